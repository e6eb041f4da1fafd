// SPDX-License-Identifier: Apache-2.0
// lobe diff: are two pictures the same, and if not, how far apart?
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>

#include "app/command.h"
#include "app/numbers.h"
#include "base/error.h"
#include "base/files.h"
#include "base/format.h"
#include "base/log.h"
#include "report/error_map.h"
#include "report/metrics_report.h"
#include "report/picture_reader.h"

namespace lobe {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    CommonOptions common;
    std::string a, b, output;
    std::optional<double> tolerance, level;
    bool allow_nonfinite = false;
};

constexpr double usual_level = 1e-3;

// What is decided of two pictures, and on which grounds.
struct Verdict {
    bool identical = false, same = false;
    std::string grounds;
};

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0);
}

// The largest of the channels' relative errors, so that no colour hides in another.
double worst_relative_rmse(const PictureMetrics& m) {
    double worst = 0;
    for (const ChannelMetrics& c : m.channels) worst = std::max(worst, c.relative_rmse);
    return worst;
}

// A criterion that is asked for decides; without any the test does at its usual level, and where
// there are no standard errors, only identical pictures are the same.
Verdict judge(const Options& options, const PictureMetrics& m, bool identical) {
    if (identical) return {true, true, "every value has the same bits"};
    if (m.odd.pixels && !options.allow_nonfinite)
        return {false, false, "values that are not finite are never the same"};
    if (m.pixels == 0) return {false, false, "no pixel could be compared"};
    Verdict v{false, true, ""};
    const auto hold = [&v](bool holds, const std::string& grounds) {
        v.same = v.same && holds;
        v.grounds += (v.grounds.empty() ? "" : "; ") + grounds;
    };
    if (options.tolerance) {
        const double error = worst_relative_rmse(m);
        const bool within = error <= *options.tolerance;
        hold(within, formatted("RMSE / mean %.4g is %s the tolerance %g", error,
                               within ? "within" : "above", *options.tolerance));
    }
    if (m.p_same && (options.level || !options.tolerance)) {
        const double level = options.level.value_or(usual_level);
        const bool likely = *m.p_same >= level;
        hold(likely, formatted("p = %.3g is %s the level %g", *m.p_same,
                               likely ? "not below" : "below", level));
    }
    if (v.grounds.empty())
        hold(false,
             "not identical, and without standard errors or --tolerance nothing else counts");
    return v;
}

void tell_notes(const ReadPicture& a, const ReadPicture& b) {
    for (const ReadPicture* p : {&a, &b}) {
        if (p->from_display)
            note(p->path +
                 " holds display values: converted from sRGB to linear light, clipped and "
                 "coarse as they are");
        std::string names;
        for (const std::string& name : p->other_channels) names += " " + name;
        if (!names.empty()) note(p->path + ": channels not compared:" + names);
        if (p->standard_error.empty() != (&a == p ? b : a).standard_error.empty())
            note(p->path + (p->standard_error.empty() ? " has no standard errors: no test is made"
                                                      : " alone has standard errors"));
    }
    const std::string seed = a.attribute("seed");
    const bool tested = !a.standard_error.empty() && !b.standard_error.empty();
    if (tested && !seed.empty() && seed == b.attribute("seed"))
        note("both pictures have seed " + seed +
             ": the test takes their samples for independent, and misses what it could see with "
             "another --seed");
}

void write_error_picture(ImageIo& images, const std::string& path, const ReadPicture& a,
                         const ReadPicture& b) {
    const bool exr = image_format(path) == "exr";
    ImageFile picture =
        exr ? absolute_error_picture(a.view(), b.view()) : false_colour_error(a.view(), b.view());
    if (exr) {
        const ImageFile& window = a.from_display ? b.file : a.file;
        picture.x = window.x;
        picture.y = window.y;
        picture.full_width = window.full_width;
        picture.full_height = window.full_height;
        picture.attributes["lobe:errorOf"] = a.path;
        picture.attributes["lobe:errorAgainst"] = b.path;
    }
    images.write(path, picture);
}

Json to_json(const Options& options, const ReadPicture& a, const ReadPicture& b,
             const PictureMetrics& m, const Verdict& v) {
    return {{"a", a.path},
            {"b", b.path},
            {"resolution", {a.file.width, a.file.height}},
            {"verdict", v.identical ? "identical"
                        : v.same    ? "same"
                                    : "differ"},
            {"grounds", v.grounds},
            {"tolerance", options.tolerance ? Json(*options.tolerance) : Json(nullptr)},
            {"level", m.p_same ? Json(options.level.value_or(usual_level)) : Json(nullptr)},
            {"worst_relative_rmse", worst_relative_rmse(m)},
            {"allow_nonfinite", options.allow_nonfinite},
            {"metrics", to_json(m)}};
}

[[noreturn]] void fail_nonfinite(const ReadPicture& a, const ReadPicture& b, const OddValues& odd) {
    throw Error(
        ExitCode::comparison,
        formatted("%zu values are NaN, %zu infinite, %zu standard errors are none: the first "
                  "at pixel %u,%u",
                  odd.nan_picture + odd.nan_reference, odd.inf_picture + odd.inf_reference,
                  odd.standard_errors, odd.first_x, odd.first_y),
        a.path + " against " + b.path,
        "--allow-nonfinite compares the other pixels and counts these");
}

int run(const Options& options) {
    set_quiet(options.common.quiet);
    if (!options.output.empty()) {
        image_format(options.output);
        check_writable(options.output);
    }
    if (!options.common.json.empty() && options.common.json != "-")
        check_writable(options.common.json);
    ImageIo images;
    const ReadPicture a = read_picture(images, options.a), b = read_picture(images, options.b);
    check_same_window(a, b);
    tell_notes(a, b);
    if (options.level && (a.standard_error.empty() || b.standard_error.empty()))
        throw Error(ExitCode::scene, "--level is of a test that needs standard errors",
                    a.standard_error.empty() ? a.path : b.path,
                    "pictures of lobe render have them from 2 samples a pixel on; or give "
                    "--tolerance");
    const PictureMetrics metrics = compare_pictures(a.view(), b.view());
    const bool fatal = metrics.odd.pixels && !options.allow_nonfinite;
    const bool identical =
        !fatal && same_bits(a.rgb, b.rgb) && same_bits(a.standard_error, b.standard_error);
    const Verdict verdict = judge(options, metrics, identical);
    if (!options.output.empty()) write_error_picture(images, options.output, a, b);
    if (options.common.json != "-" && !options.common.quiet) {
        if (!identical)
            std::printf("A  %s\nB  %s\n%s", a.path.c_str(), b.path.c_str(),
                        to_text(metrics, "A", "B").c_str());
        std::printf("%s: %s\n",
                    identical      ? "identical"
                    : verdict.same ? "same"
                                   : "differ",
                    verdict.grounds.c_str());
    }
    if (!options.common.json.empty())
        write_json(options.common.json, to_json(options, a, b, metrics, verdict).dump(2) + "\n");
    if (fatal) fail_nonfinite(a, b, metrics.odd);
    return static_cast<int>(verdict.same ? ExitCode::ok : ExitCode::comparison);
}

const char* const footer =
    R"(Exit code 0 says that the pictures are the same, 8 that they differ: with --tolerance by the
largest relative error of a channel, with --level by the test, with both by both. Without either
the test decides at level 1e-3, or, where a file has no StdError channels, only identical values
are the same. Values that are not finite are an error with code 8 unless --allow-nonfinite.

The test asks whether chance alone makes two renders of one scene differ so. It looks at the mean
of the image and at the means of 8x8 blocks, of R, G and B, with Student's t and a level corrected
for the number of blocks (Sidak). It makes no test of single pixels: with K replicates a pixel's
standard error has only K - 1 degrees of freedom. It takes the pictures for independent: render
them with different --seed. A light so rare that one picture never met it looks like a
difference.

The error image is |A - B| as R, G, B in an .exr, with Z.R, Z.G, Z.B = (A - B) over its standard
error (not a normal deviate, for the same reason); in a .png, the relative error in false colours
on a logarithmic scale from 0.1 % (black) to 100 % (white), green where not finite.

FLIP is not among the figures: no library of the system has it.)";

}  // namespace

Command add_diff_command(CLI::App& app) {
    CLI::App* verb = app.add_subcommand("diff", "are two pictures the same, and if not, how far");
    auto options = std::make_shared<Options>();
    verb->add_option("A", options->a, "picture file")->required();
    verb->add_option("B", options->b, "the picture to measure it against")->required();
    verb->add_option("-o,--output", options->output, "write an image of the error, .exr or .png")
        ->type_name("FILE");
    verb->add_option("--tolerance", options->tolerance,
                     "same if no channel's RMSE is above so much of its mean: 0.01 is 1 %")
        ->check(real_number(0, HUGE_VAL, "from 0"))
        ->type_name("X");
    verb->add_option("--level", options->level,
                     "same if chance makes the difference with at least this probability")
        ->check(real_number(0, 1, "from 0 to 1"))
        ->type_name("P");
    verb->add_flag("--allow-nonfinite", options->allow_nonfinite,
                   "leave out pixels with NaN or infinite values, and count them");
    add_common_options(*verb, options->common);
    verb->footer(footer);
    return [options] { return run(*options); };
}

}  // namespace lobe
