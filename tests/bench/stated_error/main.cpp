// SPDX-License-Identifier: Apache-2.0
// Whether renders that stop at a stated error have it: each scene at four seeds, against a render
// of ten times the samples. stated_error TARGET [SCENE WIDTHxHEIGHT]..., with TARGET as 0.01.
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "base/error.h"
#include "base/statistics.h"
#include "render/render.h"
#include "report/error_target.h"
#include "scene/read.h"
#include "study/picture_error.h"

using namespace lobe;

namespace {

constexpr int seeds = 4;
constexpr double reference_factor = 10;

struct Stop {
    Estimate picture;
    unsigned looks;
    double seconds;
};

Stop render_to(Session& session, double target, std::uint64_t seed) {
    ErrorTarget rule(target);
    session.set_seed(seed);
    RenderPlan plan;
    plan.samples = 1u << 24;
    plan.next_samples = [&](const Film& film, std::uint32_t wanted) {
        return rule.met(film) ? 0 : wanted;
    };
    const RenderOutcome outcome = render(session, plan);
    return {estimate(outcome.film), rule.looks(), outcome.seconds};
}

Reference render_reference(Session& session, double samples) {
    session.set_seed(reference_seed_bit);
    RenderPlan plan;
    plan.samples = static_cast<std::uint32_t>(samples) / LOBE_BLOCK * LOBE_BLOCK;
    const Estimate e = estimate(render(session, plan).film);
    Reference reference;
    reference.rgb = e.rgb;
    reference.luminance_error = e.luminance_error;
    reference.masked = widened(e.sees_light, e.width);
    return reference;
}

void measure(const Device& device, double target, const char* path, const char* size) {
    const KernelText kernels;
    PackOptions options;
    options.models = read_brdf_tables(kernels);
    Scene scene = read_scene(path, options.models);
    if (std::sscanf(size, "%ux%u", &scene.film.width, &scene.film.height) != 2)
        throw Error(ExitCode::usage, "the size is not WIDTHxHEIGHT", size);
    const PackedScene packed = pack_scene(scene, options);
    Session session(device, kernels, packed);

    std::vector<Stop> stops;
    double samples = 0, seconds = 0, looks = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
        stops.push_back(render_to(session, target, seed));
        samples += stops.back().picture.mean_samples / seeds;
        seconds += stops.back().seconds / seeds;
        looks += double(stops.back().looks) / seeds;
    }
    const Reference reference = render_reference(session, samples * reference_factor);
    std::vector<double> stated, found;
    double outside = 0;  // of the errors, in the 0.1 % of the pixels with the largest
    for (const Stop& stop : stops) {
        std::vector<bool> masked = reference.masked;
        for (std::size_t p = 0; p < masked.size(); ++p)
            masked[p] = masked[p] || stop.picture.sees_light[p];
        const PictureError error = picture_error(stop.picture, reference, masked);
        stated.push_back(*stop.picture.relative_standard_error / target);
        found.push_back(std::sqrt(error.mse) / target);
        outside += error.trimmed_share / seeds;
    }
    std::printf("%-50s %-8s %8.0f %5.1f %7.1f  %6.3f +- %.3f  %6.3f +- %.3f  %5.1f\n", path, size,
                samples, looks, seconds, mean(stated), standard_error(stated), mean(found),
                standard_error(found), 100 * outside);
    std::fflush(stdout);
}

}  // namespace

int main(int count, char** words) {
    if (count < 4 || count % 2) {
        std::fprintf(stderr, "stated_error TARGET [SCENE WIDTHxHEIGHT]...\n");
        return static_cast<int>(ExitCode::usage);
    }
    try {
        const Device device = open_device("");
        std::printf("%-50s %-8s %8s %5s %7s  %16s  %16s  %s\n", "scene", "film", "samples", "looks",
                    "seconds", "stated / target", "found / target", "% in 0.1 % of pixels");
        for (int i = 2; i < count; i += 2)
            measure(device, std::atof(words[1]), words[i], words[i + 1]);
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.message().c_str());
        return static_cast<int>(error.code());
    }
}
