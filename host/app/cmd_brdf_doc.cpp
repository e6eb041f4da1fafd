// SPDX-License-Identifier: Apache-2.0
// lobe brdf doc: a page a model, from its own file and from measurements.
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>

#include "app/lab_options.h"
#include "app/numbers.h"
#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "base/signals.h"
#include "lab/page/model_page.h"
#include "lab/plot/plot_polar.h"
#include "report/image_io.h"
#include "report/picture.h"
#include "report/svg.h"

namespace lobe {
namespace {

struct Options {
    LabOptions lab;
    std::string folder, checks;
    SpherePlan sphere{240, 128, 1};
};

const std::vector<double> table_angles = {0, 30, 45, 60, 75, 85}, plot_angles = {0, 30, 60};

void make_folder(const std::string& folder) {
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    if (fault)
        throw Error(ExitCode::output, "the folder cannot be made: " + fault.message(), folder);
    check_writable(folder + "/index.md");
}

nlohmann::json read_checks(const std::string& path) {
    const nlohmann::json file = nlohmann::json::parse(read_file(path), nullptr, false);
    if (file.is_discarded()) throw Error(ExitCode::scene, "no JSON", path);
    return file;
}

// A look at the model that takes seconds, or what a file says.
void check(ModelPage& page, const Lab& lab, const std::string& file) {
    const BrdfTable& model = page.table.subject.model;
    if (!file.empty()) {
        page.checks = check_lines(read_checks(file), model.name, file);
        page.checked_by = "lobe brdf check " + model.name;
        return;
    }
    CheckOptions options;
    options.effort = CheckEffort::reduced();
    options.kernel_models = {model};
    std::vector<ModelReport> reports = {
        check_model(lab.device, lab.kernels, lab.models, model, options)};
    judge(reports);
    page.checks = check_lines(reports[0]);
    page.checked_by = "lobe brdf check " + model.name + " --grid reduced";
}

// Writes a model's page and plots; false if a signal asked to stop.
bool write_page(const Options& options, const Lab& lab, const Subject& subject, ImageIo& images) {
    const std::string& name = subject.model.name;
    const std::string base = options.folder + "/" + name;
    note("writing " + base + ".md");
    BrdfProbe probe = lab.probe(subject);
    ModelPage page;
    page.table = measure_model(probe, subject, table_angles);
    page.device = lab.device.info().name;
    page.polar = name + "-polar.svg";
    page.sphere = name + "-sphere.png";
    write_file(base + "-polar.svg", to_svg(draw_polar({polar_panel(probe, subject, plot_angles)})));
    const SpherePicture sphere = render_sphere(lab.device, lab.kernels, lab.models, subject,
                                               options.sphere, [] { return stop_signal() != 0; });
    if (sphere.stopped) return false;
    images.write(base + "-sphere.png", display_picture(sphere.picture));
    page.sphere_picture = sphere.picture;
    check(page, lab, options.checks);
    if (stop_signal()) return false;
    write_file(base + ".md", to_markdown(page));
    return true;
}

int run(Options options) {
    make_folder(options.folder);
    if (options.lab.models.empty()) options.lab.models = {"all"};
    const std::optional<Lab> lab = open_lab(options.lab);
    if (!lab) return stop_exit_code();
    ImageIo images;
    std::vector<BrdfTable> written;
    nlohmann::ordered_json json = {{"folder", options.folder}, {"models", nlohmann::json::array()}};
    for (const Subject& subject : lab->subjects) {
        if (!write_page(options, *lab, subject, images)) return stop_exit_code();
        written.push_back(subject.model);
        json["models"].push_back(subject.model.name);
    }
    write_file(options.folder + "/index.md", index_page(written));
    const CommonOptions& common = options.lab.common;
    if (common.json != "-" && !common.quiet)
        std::printf("%zu pages, %s/index.md\n", written.size(), options.folder.c_str());
    if (!common.json.empty()) write_json(common.json, json.dump(2) + "\n");
    return 0;
}

}  // namespace

Command add_brdf_doc(CLI::App& verb) {
    CLI::App* doc = verb.add_subcommand("doc", "a page a model, from its file and from measuring");
    auto options = std::make_shared<Options>();
    add_lab_options(*doc, options->lab);
    doc->get_option("models")->description("names of models, files of your own, or all (all)");
    doc->add_option("-o,--output", options->folder, "folder of the pages")
        ->required()
        ->type_name("DIR");
    doc->add_option("--checks", options->checks,
                    "results of `lobe brdf check --json FILE`, in place of checking a little")
        ->type_name("FILE");
    doc->add_option("--spp", options->sphere.samples, "samples a pixel of the spheres (128)")
        ->transform(whole_number(1, 1u << 20))
        ->type_name("NUMBER");
    return [options] { return run(*options); };
}

}  // namespace lobe
