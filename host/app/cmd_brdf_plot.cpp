// SPDX-License-Identifier: Apache-2.0
// lobe brdf plot: what models reflect, in pictures.
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/lab_options.h"
#include "app/numbers.h"
#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "base/signals.h"
#include "lab/plot/plot_curves.h"
#include "lab/plot/plot_polar.h"
#include "lab/plot/plot_sphere.h"
#include "lab/plot/sphere_scene.h"
#include "report/image_io.h"
#include "report/picture.h"
#include "report/raster.h"
#include "report/svg.h"

namespace lobe {
namespace {

struct Options {
    LabOptions lab;
    std::string output = "plot.svg", kind = "polar", scale = "auto";
    std::vector<double> angles = {0, 30, 60}, at;
    double azimuth = 0;
    std::vector<std::string> vary;
    SpherePlan sphere;
};

std::string ending_of(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

bool is_svg(const std::string& path) { return ending_of(path) == ".svg"; }

void check_output(const Options& options) {
    const std::string ending = ending_of(options.output);
    if (ending != ".svg" && ending != ".png")
        throw Error(ExitCode::usage, "cannot write a plot of type '" + ending + "'", options.output,
                    "plots end in .svg or .png");
    if (ending == ".svg" && options.kind == "sphere")
        throw Error(ExitCode::usage, "a rendered sphere is no line drawing", options.output,
                    "give -o FILE.png");
    check_writable(options.output);
}

Drawing polar(const Options& options, const Lab& lab) {
    std::vector<PolarPanel> panels;
    for (const Subject& subject : lab.subjects) {
        BrdfProbe probe = lab.probe(subject);
        panels.push_back(
            polar_panel(probe, subject, options.angles, glm::radians(options.azimuth)));
    }
    const Scale scale = options.scale == "log"      ? Scale::log
                        : options.scale == "linear" ? Scale::linear
                                                    : Scale::automatic;
    return draw_polar(panels, scale);
}

Drawing curves(const Options& options, const Lab& lab) {
    std::vector<LobePanel> panels;
    for (const Subject& subject : lab.subjects) {
        BrdfProbe probe = lab.probe(subject);
        const std::string name = named_for(options.vary, subject.model.name);
        const std::vector<std::size_t> shaping = shaping_parameters(probe, subject, name);
        if (shaping.empty()) {
            panels.push_back(lobe_panel(probe, subject));
            continue;
        }
        const Sharpened model{probe, subject, shaping};
        panels.push_back(lobe_panel(model, options.at.empty() ? model.few() : options.at));
    }
    return draw_lobes(panels, options.scale == "log");
}

// Renders all and writes the sheet, unless a signal asks to stop.
void spheres(const Options& options, const Lab& lab, nlohmann::ordered_json& json) {
    std::vector<SphereTile> tiles;
    json["models"] = nlohmann::ordered_json::array();
    for (const Subject& subject : lab.subjects) {
        note("rendering " + subject.model.name);
        const SpherePicture sphere =
            render_sphere(lab.device, lab.kernels, lab.models, subject, options.sphere,
                          [] { return stop_signal() != 0; });
        if (sphere.stopped) return;
        const std::optional<double>& error = sphere.picture.relative_standard_error;
        if (options.lab.common.json != "-" && !options.lab.common.quiet)
            std::printf("%-20s error %s, %u samples a pixel, %.1f s\n", subject.model.name.c_str(),
                        error_text(sphere.picture).c_str(), options.sphere.samples, sphere.seconds);
        json["models"].push_back(
            {{"model", subject.model.name},
             {"spp", options.sphere.samples},
             {"render_s", sphere.seconds},
             {"relative_standard_error", error ? nlohmann::ordered_json(*error) : nullptr}});
        tiles.push_back({subject.model.name, subject.text(), display_picture(sphere.picture)});
    }
    ImageIo images;
    images.write(options.output, sphere_sheet(tiles, images));
}

void write_drawing(const std::string& path, const Drawing& drawing) {
    if (is_svg(path)) {
        write_file(path, to_svg(drawing));
        return;
    }
    ImageIo images;
    images.write(path, rasterise(drawing, images));
}

int run(Options options) {
    check_output(options);
    if (options.lab.models.empty()) options.lab.models = {"modified_phong", "rational"};
    const std::optional<Lab> lab = open_lab(options.lab);
    if (!lab) return stop_exit_code();
    nlohmann::ordered_json json = {{"output", options.output}, {"kind", options.kind}};
    if (options.kind == "sphere")
        spheres(options, *lab, json);
    else
        write_drawing(options.output,
                      options.kind == "polar" ? polar(options, *lab) : curves(options, *lab));
    if (stop_signal()) return stop_exit_code();
    const CommonOptions& common = options.lab.common;
    if (common.json != "-" && !common.quiet) std::printf("%s\n", options.output.c_str());
    if (!common.json.empty()) write_json(common.json, json.dump(2) + "\n");
    return 0;
}

}  // namespace

Command add_brdf_plot(CLI::App& verb) {
    CLI::App* plot = verb.add_subcommand("plot", "polar plots, lobes and rendered spheres");
    auto options = std::make_shared<Options>();
    add_lab_options(*plot, options->lab);
    plot->get_option("models")->description(
        "names of models, files of your own, or all (the paper's: modified_phong rational)");
    plot->add_option("-o,--output", options->output, "picture to write, .svg or .png (plot.svg)")
        ->type_name("FILE");
    plot->add_option("--kind", options->kind,
                     "polar: in the plane of incidence; curves: lobes of several sharpnesses; "
                     "sphere: rendered")
        ->check(CLI::IsMember({"polar", "curves", "sphere"}));
    plot->add_option("--scale", options->scale, "of values: auto, linear or log")
        ->check(CLI::IsMember({"auto", "linear", "log"}));
    plot->add_option("--angles", options->angles, "of view of a polar plot (0,30,60)")
        ->delimiter(',')
        ->check(real_number(0, 90, "from 0 to 90"))
        ->type_name("DEG,...");
    plot->add_option("--azimuth", options->azimuth, "of the plane of incidence, in degrees (0)")
        ->check(real_number(-360, 360, "from -360 to 360"))
        ->type_name("DEG");
    plot->add_option("--vary", options->vary, "the parameter whose values are the curves")
        ->type_name("[MODEL.]NAME");
    plot->add_option("--at", options->at, "its values")
        ->delimiter(',')
        ->check(real_number(0, std::numeric_limits<double>::max(), "of its range"))
        ->type_name("VALUE,...");
    plot->add_option("--spp", options->sphere.samples, "samples a pixel of a sphere (64)")
        ->transform(whole_number(1, 1u << 20))
        ->type_name("NUMBER");
    plot->add_option("--seed", options->sphere.seed, "of a sphere's random numbers (1)")
        ->transform(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
        ->type_name("NUMBER");
    return [options] { return run(*options); };
}

}  // namespace lobe
