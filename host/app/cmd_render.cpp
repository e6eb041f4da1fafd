// SPDX-License-Identifier: Apache-2.0
// lobe render: the main job, from a scene file to pictures with their error and their time.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>

#include "app/background_start.h"
#include "app/command.h"
#include "app/numbers.h"
#include "app/render_job.h"
#include "app/scene_options.h"
#include "app/user_models.h"
#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "base/progress.h"
#include "base/signals.h"
#include "base/timer.h"
#include "lab/trial/model_fault.h"
#include "render/render.h"
#include "report/image_io.h"
#include "report/picture.h"
#include "report/render_report.h"

namespace lobe {
namespace {

struct Options {
    SceneOptions scene;
    RenderOutputs written;
    RenderGoals goals;  // without the samples, which the scene may state
    std::vector<std::string> outputs;
    std::uint64_t seed = 0;
    double watchdog = 60;
    bool strict = false;
    std::vector<std::string> command_line;
};

// Where an error or a time is the goal, and no --spp is the ceiling.
constexpr std::uint32_t endless = 1u << 30;

void add_options(CLI::App& verb, Options& o) {
    add_common_options(verb, o.written.common);
    add_scene_options(verb, o.scene);
    verb.add_option("-o,--output", o.outputs, "picture to write, .exr or .png; may be repeated")
        ->type_name("FILE");
    verb.add_option("--seed", o.seed, "of all random numbers (0)")
        ->transform(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
        ->type_name("NUMBER");
    verb.add_option("--exposure", o.written.exposure, "factor for PNG pictures (1)")
        ->check(real_number(1e-30, 1e30, "from 1e-30 to 1e30"))
        ->type_name("NUMBER");
    verb.add_option("--watchdog", o.watchdog,
                    "end a launch that takes so many seconds more than it should (60); 0 never")
        ->check(real_number(0, 1e9, "from 0 to 1e9"))
        ->type_name("SECONDS");
    verb.add_option("--error", o.goals.error,
                    "render until the relative standard error is below this, e.g. 1%; --spp is "
                    "the ceiling")
        ->transform(part_of_one())
        ->type_name("PERCENT%");
    verb.add_option("--time", o.goals.time,
                    "render until so many seconds have passed since the start; --spp is the "
                    "ceiling")
        ->check(real_number(1e-3, 1e9, "from 0.001 to 1e9"))
        ->type_name("SECONDS");
    verb.add_flag("--adaptive", o.goals.adaptive,
                  "more samples where the picture is noisier, by a pilot render that is thrown "
                  "away");
    verb.add_option("--html", o.written.html, "a page of the render that needs nothing beside it")
        ->type_name("FILE");
    verb.add_flag("--strict", o.strict, "exit with 6 if any sample is not finite");
}

// Fails for pictures and results that could not be written, before the work is done.
void check_outputs(const std::vector<std::string>& pictures, const std::string& json) {
    for (const std::string& picture : pictures) image_format(picture);
    for (const std::string& picture : pictures) check_writable(picture);
    if (!json.empty() && json != "-") check_writable(json);
}

// The picture of a render without --output: as the scene file says, as EXR if we cannot write that
// format, else lobe.exr.
std::string standard_output_name(const Scene& scene) {
    if (scene.film.filename.empty()) return "lobe.exr";
    try {
        image_format(scene.film.filename);
        return scene.film.filename;
    } catch (const Error&) {
        return std::filesystem::path(scene.film.filename).replace_extension(".exr").string();
    }
}

void warn_of_status(const RenderStatus& status) {
    const std::string first = ", for example in pixel " +
                              std::to_string(status.counters[LOBE_STATUS_PIXEL] - 1) + " sample " +
                              std::to_string(status.counters[LOBE_STATUS_SAMPLE]);
    if (status.nonfinite())
        warn(std::to_string(status.nonfinite()) + " samples were not finite and count as black" +
             first);
    if (status.negative())
        warn(std::to_string(status.negative()) + " samples were negative" + first);
    if (status.trapped())
        throw Error(ExitCode::internal, "the kernel needed what was compiled out", "",
                    "render with --features all and report this as a fault of lobe");
}

// The scene as the device wants it, each step timed. Its kernel is compiled meanwhile, unless that
// holds a model of the user's own, which is to be tried first.
PackedScene prepare(const Options& options, KernelText& kernels, BackgroundStart& start,
                    RenderReport& report, RenderGoals& goals) {
    Stopwatch watch;
    const Scene scene = read_scene_for(options.scene, kernels);
    check_trust(scene, options.scene.trust_scene_kernels);
    if (report.outputs.empty()) {
        report.outputs = {standard_output_name(scene)};
        check_outputs(report.outputs, "");
    }
    report.scene = scene.path;
    report.scene_hash = scene.hash;
    report.dialect = scene.dialect == Dialect::v3 ? "v3" : "v4";
    goals.samples = scene.samples_per_pixel;
    if ((goals.error || goals.time) && !options.scene.spp) goals.samples = endless;
    report.seconds.parse = watch.restart();

    const PackOptions pack{read_brdf_tables(kernels), options.scene.features == "all",
                           options.scene.integrator};
    const KernelNeeds needs = kernel_needs(scene, pack);
    if (std::none_of(needs.models.begin(), needs.models.end(),
                     [](const BrdfTable& model) { return model.own; }))
        start.compile(kernels, needs);
    PackedScene packed = pack_scene(scene, pack);
    if (packed.lights.lights.empty() && !scene.environment)
        warn("the scene has no light: the picture will be black", scene.path);
    report.features = packed.features;
    report.integrator = packed.integrator;
    for (const BrdfTable& model : packed.models) report.models.push_back(model.name);
    report.triangles = packed.triangles.size();
    report.spheres = packed.spheres.size();
    report.lights = packed.lights.lights.size();
    report.seconds.bvh = watch.restart();
    return packed;
}

int stopped_early() {
    note("stopped before the first sample: nothing is written");
    return stop_exit_code();
}

// The user's own models are compiled with all the others: a fault of theirs is told as theirs.
std::unique_ptr<Session> open_session(BackgroundStart& start, const KernelText& kernels,
                                      const PackedScene& packed, Watchdog& watchdog) {
    try {
        auto kernel = start.kernel();
        if (!kernel) kernel.emplace(start.device(), kernels, packed);
        return std::make_unique<Session>(start.device(), std::move(*kernel), packed, &watchdog);
    } catch (const Error& error) {
        throw users_fault(error, kernels);
    }
}

int run(const Options& options) {
    set_quiet(options.written.common.quiet);
    install_signal_handlers();
    const Stopwatch total;
    KernelText kernels = open_kernels(options.written.common);
    RenderReport report;
    report.version = LOBE_VERSION;
    report.seed = options.seed;
    report.command = options.command_line;
    report.outputs = options.outputs;
    check_outputs(options.outputs, options.written.common.json);
    if (!options.written.html.empty()) check_writable(options.written.html);
    RenderGoals goals = options.goals;
    BackgroundStart start(options.written.common.device);
    PackedScene packed = prepare(options, kernels, start, report, goals);

    ImageIo images;
    const Device& device = start.device();
    report.device = device.info();
    if (!try_user_models(device, kernels, packed.models, options.written.common))
        return stopped_early();
    RenderJob job(options.written, report, packed, images, total);
    Watchdog watchdog(options.watchdog, [&](double seconds) { job.end_hung(seconds); });
    const auto session = open_session(start, kernels, packed, watchdog);
    free_shapes(packed);
    Film::check_memory(static_cast<double>(session->width()) * session->height(), goals.samples);
    job.render(*session, goals, options.seed, watchdog);
    warn_of_status(*report.status);
    if (report.picture.mean_samples == 0) return stopped_early();  // not worth the old picture
    job.write();
    session->keep_program();
    if (report.partial) return stop_exit_code();
    if (options.strict && report.status->nonfinite()) return static_cast<int>(ExitCode::nonfinite);
    return 0;
}

}  // namespace

Command add_render_command(CLI::App& app, const std::vector<std::string>& command_line) {
    CLI::App* verb = app.add_subcommand("render", "render a scene to pictures with error bars");
    auto options = std::make_shared<Options>();
    options->command_line = command_line;
    add_options(*verb, *options);
    return [options] { return run(*options); };
}

}  // namespace lobe
