// SPDX-License-Identifier: Apache-2.0
// lobe render: the main job, from a scene file to pictures with their error and their time.
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>

#include "app/command.h"
#include "app/numbers.h"
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
    CommonOptions common;
    SceneOptions scene;
    std::vector<std::string> outputs;
    std::uint64_t seed = 0;
    double exposure = 1, watchdog = 60;
    bool strict = false;
    std::string command_line;
};

void add_options(CLI::App& verb, Options& o) {
    add_common_options(verb, o.common);
    add_scene_options(verb, o.scene);
    verb.add_option("-o,--output", o.outputs, "picture to write, .exr or .png; may be repeated")
        ->type_name("FILE");
    verb.add_option("--seed", o.seed, "of all random numbers (0)")
        ->transform(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
        ->type_name("NUMBER");
    verb.add_option("--exposure", o.exposure, "factor for PNG pictures (1)")
        ->check(real_number(1e-30, 1e30, "from 1e-30 to 1e30"))
        ->type_name("NUMBER");
    verb.add_option("--watchdog", o.watchdog,
                    "end a launch that takes so many seconds more than it should (60); 0 never")
        ->check(real_number(0, 1e9, "from 0 to 1e9"))
        ->type_name("SECONDS");
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

// Shows how far the render is; the error is estimated anew when it pays, for it costs a pass.
class RenderWatch {
  public:
    void operator()(const RenderProgress& progress) {
        if (progress.round_ended && !is_quiet() && since_error_.seconds() > pause_) {
            const Stopwatch watch;
            error_ = "error " + error_text(estimate(progress.film));
            pause_ = std::max(1.0, 30 * watch.seconds());
            since_error_.restart();
        }
        shown_.update(progress.samples_done, progress.samples_total, error_);
    }

  private:
    Progress shown_{"render", "samples"};
    Stopwatch since_error_;
    double pause_ = 1;  // seconds between estimates: they stay below a thirtieth of the time
    std::string error_;
};

PictureFacts picture_facts(const RenderReport& r, const LobeFrame& frame,
                           const std::string& command_line) {
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
    if (r.status) a["lobe:nonfinite"] = static_cast<int>(r.status->nonfinite());
    a["lobe:partial"] = static_cast<int>(r.partial);
    a["lobe:version"] = r.version;
    a["lobe:commandLine"] = command_line;
    if (r.picture.relative_standard_error)
        a["lobe:relativeStandardError"] = *r.picture.relative_standard_error;
    return facts;
}

void write_pictures(RenderReport& report, const LobeFrame& frame, const Options& options,
                    ImageIo& io) {
    const Stopwatch watch;
    for (const std::string& output : report.outputs) {
        if (image_format(output) == "png") {
            io.write(output, display_picture(report.picture, options.exposure));
        } else {
            io.write(output, float_picture(report.picture,
                                           picture_facts(report, frame, options.command_line)));
        }
    }
    report.seconds.write = watch.seconds();
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

// Everything up to the first launch: the scene as the device wants it, each step timed.
PackedScene prepare(const Options& options, KernelText& kernels, RenderReport& report,
                    RenderPlan& plan) {
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
    plan.samples = scene.samples_per_pixel;
    report.seconds.parse = watch.restart();

    PackedScene packed =
        pack_scene(scene, {read_brdf_tables(kernels), options.scene.features == "all"});
    if (packed.lights.lights.empty() && !scene.environment)
        warn("the scene has no light: the picture will be black", scene.path);
    report.features = packed.features;
    for (const BrdfTable& model : packed.models) report.models.push_back(model.name);
    report.triangles = packed.triangles.size();
    report.spheres = packed.spheres.size();
    report.lights = packed.lights.lights.size();
    report.seconds.bvh = watch.restart();
    return packed;
}

// Better refused now than killed hours later.
void check_host_memory(const Session& session, const RenderPlan& plan) {
    const double needed =
        Film::peak_bytes(static_cast<double>(session.width()) * session.height(), plan.samples);
    const double there = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * sysconf(_SC_PAGESIZE);
    if (needed > there)
        throw Error(ExitCode::device,
                    "the film needs " + bytes_text(needed) + " of host memory, there are " +
                        bytes_text(there),
                    "", "render a part with --crop, or fewer samples");
}

int stopped_early() {
    note("stopped before the first sample: nothing is written");
    return stop_exit_code();
}

// The user's own models are compiled with all the others: a fault of theirs is told as theirs.
std::unique_ptr<Session> open_session(const Device& device, const KernelText& kernels,
                                      const PackedScene& packed, Watchdog& watchdog) {
    SessionOptions options;
    options.watchdog = &watchdog;
    try {
        return std::make_unique<Session>(device, kernels, packed, options);
    } catch (const Error& error) {
        throw users_fault(error, kernels);
    }
}

// A render from its first launch to its last line of output.
struct Job {
    const Options& options;
    RenderReport& report;
    const PackedScene& packed;
    ImageIo& images;
    const Stopwatch& total;
    const Session* session = nullptr;
    const Film* film = nullptr;  // complete blocks
    Stopwatch rendering;

    RenderOutcome render_watched(Session& ready, RenderPlan& plan) {
        session = &ready;
        RenderWatch shown;
        plan.progress = [&](const RenderProgress& p) {
            film = &p.film;
            shown(p);
        };
        rendering.restart();
        plan.stop = [] { return stop_signal() != 0; };
        return render(ready, plan);
    }

    void take(const Film& rendered, double seconds, bool stopped) {
        report.seconds.compile = session->compile_seconds();
        report.seconds.upload = session->upload_seconds();
        report.seconds.render = seconds;
        report.picture = estimate(rendered);
        report.hash = image_hash(report.picture);
        report.partial = stopped;
        report.width = session->width();
        report.height = session->height();
        report.device_bytes = session->device_bytes();
    }

    void write() {
        write_pictures(report, packed.frame, options, images);
        report.seconds.total = total.seconds();
        if (options.common.json != "-" && !options.common.quiet)
            std::fputs(to_text(report).c_str(), stdout);
        if (!options.common.json.empty())
            write_json(options.common.json, to_json(report).dump(2) + "\n");
    }

    // For the watchdog, while the other thread waits for a launch that never ends and cannot be
    // cancelled: the picture so far, and the end of the process.
    [[noreturn]] void end_hung(double seconds) {
        show_live_line("");
        std::string hint = "nothing was complete, nothing is written";
        try {
            if (film && film->samples() > 0) {
                take(*film, rendering.seconds(), true);
                write();
                hint = "the picture of the samples before it is written";
            }
        } catch (const std::exception& error) {
            hint = std::string("the picture so far cannot be written: ") + error.what();
        }
        for (const BrdfTable& model : packed.models)
            if (model.own) hint += "; do the loops of " + model.file + " end for all directions?";
        const Error error(ExitCode::device,
                          "a launch did not end within " + std::to_string(std::lround(seconds)) +
                              " s: the render is ended",
                          report.scene, hint);
        std::fflush(stdout);
        std::fprintf(stderr, "%s\n", error.message().c_str());
        _exit(static_cast<int>(error.code()));
    }
};

int run(const Options& options) {
    set_quiet(options.common.quiet);
    install_signal_handlers();
    const Stopwatch total;
    KernelText kernels = open_kernels(options.common);
    RenderReport report;
    report.version = LOBE_VERSION;
    report.seed = options.seed;
    report.outputs = options.outputs;
    check_outputs(options.outputs, options.common.json);
    RenderPlan plan;
    const PackedScene packed = prepare(options, kernels, report, plan);

    ImageIo images;  // opens its module while the device renders
    const Device device = open_device(options.common.device);
    report.device = device.info();
    if (!try_user_models(device, kernels, packed.models, options.common)) return stopped_early();
    Job job{options, report, packed, images, total};
    Watchdog watchdog(options.watchdog, [&](double seconds) { job.end_hung(seconds); });
    plan.watchdog = &watchdog;
    const auto session = open_session(device, kernels, packed, watchdog);
    session->set_seed(options.seed);
    check_host_memory(*session, plan);
    const RenderOutcome outcome = job.render_watched(*session, plan);
    job.take(outcome.film, outcome.seconds, outcome.stopped);
    report.status = session->status();
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
    for (const std::string& word : command_line)
        options->command_line += (options->command_line.empty() ? "" : " ") + word;
    add_options(*verb, *options);
    return [options] { return run(*options); };
}

}  // namespace lobe
