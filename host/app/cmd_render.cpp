// SPDX-License-Identifier: Apache-2.0
// lobe render: the main job, from a scene file to pictures with their error and their time.
#include <cstdio>
#include <memory>

#include "app/command.h"
#include "app/scene_options.h"
#include "base/error.h"
#include "base/files.h"
#include "base/kernel_text.h"
#include "base/log.h"
#include "base/progress.h"
#include "base/signals.h"
#include "base/timer.h"
#include "render/render.h"
#include "report/image_io.h"
#include "report/picture.h"
#include "report/render_report.h"

namespace lobe {
namespace {

struct Options {
    CommonOptions common;
    SceneOptions scene;
    std::vector<std::string> outputs;
    std::uint64_t seed = 0;
    double exposure = 1;
    bool strict = false;
    std::string command_line;
};

void add_options(CLI::App& verb, Options& o) {
    add_common_options(verb, o.common);
    add_scene_options(verb, o.scene);
    verb.add_option("-o,--output", o.outputs, "picture to write, .exr or .png; may be repeated")->type_name("FILE");
    verb.add_option("--seed", o.seed, "of all random numbers (0)");
    verb.add_option("--exposure", o.exposure, "factor for PNG pictures (1)")->check(CLI::PositiveNumber);
    verb.add_flag("--strict", o.strict, "exit with 6 if any sample is not finite");
}

// Where to write: as asked, else as the scene file says if we can write that, else lobe.exr.
std::vector<std::string> choose_outputs(const Options& options, const Scene& scene) {
    std::vector<std::string> outputs = options.outputs;
    if (outputs.empty()) outputs.push_back(scene.film.filename.empty() ? "lobe.exr" : scene.film.filename);
    for (const std::string& output : outputs) {
        image_format(output);
        check_writable(output);
    }
    return outputs;
}

// Shows how far the render is; the error is estimated anew when it pays, for it costs a pass.
class RenderWatch {
  public:
    void operator()(const RenderProgress& progress) {
        if (progress.block_ended && since_error_.seconds() > 1) {
            error_ = "error " + error_text(estimate(progress.film));
            since_error_.restart();
        }
        shown_.update(progress.samples_done, progress.samples_total, error_);
    }

  private:
    Progress shown_{"render", "samples"};
    Stopwatch since_error_;
    std::string error_;
};

PictureFacts picture_facts(const RenderReport& r, const LobeFrame& frame, const std::string& command_line) {
    PictureFacts facts;
    facts.frame = frame;
    auto& a = facts.attributes;
    a["samplesPerPixel"] = static_cast<int>(r.picture.samples);
    a["renderTimeSeconds"] = r.seconds.render;
    a["lobe:seed"] = std::to_string(r.seed);
    a["lobe:sampleRange"] = "0:" + std::to_string(r.picture.samples);
    a["lobe:block"] = LOBE_BLOCK;
    a["lobe:replicates"] = LOBE_REPLICATES;
    a["lobe:sceneHash"] = r.scene_hash;
    a["lobe:imageHash"] = r.hash;
    a["lobe:device"] = r.device.name + ", " + r.device.platform + " " + r.device.driver;
    a["lobe:nonfinite"] = static_cast<int>(r.status.nonfinite());
    a["lobe:partial"] = static_cast<int>(r.partial);
    a["lobe:version"] = r.version;
    a["lobe:commandLine"] = command_line;
    if (r.picture.relative_standard_error) a["lobe:relativeStandardError"] = *r.picture.relative_standard_error;
    return facts;
}

void write_pictures(RenderReport& report, const LobeFrame& frame, const Options& options, ImageIo& io) {
    const Stopwatch watch;
    for (const std::string& output : report.outputs) {
        if (image_format(output) == "png") {
            io.write(output, display_picture(report.picture, options.exposure));
        } else {
            io.write(output, float_picture(report.picture, picture_facts(report, frame, options.command_line)));
        }
    }
    report.seconds.write = watch.seconds();
}

void warn_of_status(const RenderStatus& status) {
    const std::string first = ", first in pixel " + std::to_string(status.counters[LOBE_STATUS_PIXEL] - 1) +
                              " sample " + std::to_string(status.counters[LOBE_STATUS_SAMPLE]);
    if (status.nonfinite())
        warn(std::to_string(status.nonfinite()) + " samples were not finite and count as black" + first);
    if (status.negative()) warn(std::to_string(status.negative()) + " samples were negative" + first);
    if (status.trapped())
        throw Error(ExitCode::internal, "the kernel needed what was compiled out",
                    "", "render with --features all and report this as a fault of lobe");
}

int run(const Options& options) {
    set_quiet(options.common.quiet);
    install_signal_handlers();
    const Stopwatch total;
    RenderReport report;
    report.version = LOBE_VERSION;
    report.seed = options.seed;

    Stopwatch watch;
    const KernelText kernels(options.common.kernel_folder);
    const std::vector<BrdfTable> models = read_brdf_tables(kernels);
    Scene scene = read_scene_for(options.scene, models);
    report.outputs = choose_outputs(options, scene);
    report.seconds.parse = watch.restart();

    PackOptions pack;
    pack.all_features = options.scene.features == "all";
    for (const BrdfTable& model : models) pack.all_models.push_back(model.name);
    const PackedScene packed = pack_scene(scene, pack);
    report.seconds.bvh = watch.restart();
    scene.shapes.clear();  // the packed form is all that is needed from here on
    if (packed.lights.lights.empty() && !scene.environment)
        warn("the scene has no light: the picture will be black", scene.path);

    ImageIo images;
    const Device device = open_device(options.common.device);
    Session session(device, kernels, packed);
    session.set_seed(options.seed);
    report.seconds.compile = session.compile_seconds();
    report.seconds.upload = session.upload_seconds();

    RenderPlan plan;
    plan.samples = scene.samples_per_pixel;
    RenderOutcome outcome = [&] {
        RenderWatch shown;
        return render(session, plan, std::ref(shown), [] { return stop_signal() != 0; });
    }();
    report.seconds.render = outcome.seconds;
    report.picture = estimate(outcome.film);
    report.hash = image_hash(report.picture);
    report.partial = outcome.stopped;
    report.status = session.status();
    report.scene = scene.path;
    report.scene_hash = scene.hash;
    report.dialect = scene.dialect == Dialect::v3 ? "v3" : "v4";
    report.device = device.info();
    report.width = session.width();
    report.height = session.height();
    report.features = packed.features;
    report.models = packed.models;
    report.triangles = packed.triangles.size();
    report.spheres = packed.spheres.size();
    report.lights = packed.lights.lights.size();
    report.device_bytes = session.device_bytes();
    warn_of_status(report.status);
    write_pictures(report, packed.frame, options, images);
    session.keep_program();
    report.seconds.total = total.seconds();

    if (options.common.json != "-") std::fputs(to_text(report).c_str(), stdout);
    if (!options.common.json.empty()) write_json(options.common.json, to_json(report).dump(2) + "\n");
    if (outcome.stopped) return stop_exit_code();
    if (options.strict && report.status.nonfinite()) return static_cast<int>(ExitCode::nonfinite);
    return 0;
}

}  // namespace

Command add_render_command(CLI::App& app, const std::vector<std::string>& command_line) {
    CLI::App* verb = app.add_subcommand("render", "render a scene to pictures with error bars");
    auto options = std::make_shared<Options>();
    for (const std::string& word : command_line) options->command_line += (options->command_line.empty() ? "" : " ") + word;
    add_options(*verb, *options);
    return [options] { return run(*options); };
}

}  // namespace lobe
