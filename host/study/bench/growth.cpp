// SPDX-License-Identifier: Apache-2.0
#include "study/bench/growth.h"

#include <optional>
#include <utility>

#include "base/error.h"
#include "base/format.h"
#include "base/memory_peak.h"
#include "base/progress.h"
#include "base/statistics.h"
#include "base/timer.h"
#include "render/render.h"
#include "report/estimate.h"
#include "study/bench/growth_scenes.h"

namespace lobe {
namespace {

// Nothing if it was stopped.
std::optional<GrowthPoint> measure(const Device& device, const KernelText& kernels,
                                   const RenderSizes& sizes, const std::function<bool()>& stop) {
    const auto pixels = static_cast<double>(sizes.film * sizes.film);
    Film::check_memory(pixels, sizes.samples);
    GrowthPoint point;
    forget_memory_peak();
    PackedScene packed;
    {
        const Scene scene =
            torus_scene(sizes.triangles, sizes.lights, static_cast<std::uint32_t>(sizes.film));
        const Stopwatch watch;
        packed = pack_scene(scene);
        point.build_seconds = watch.seconds();
    }
    Session session(device, kernels, packed);
    free_shapes(packed);
    RenderPlan plan;
    plan.samples = static_cast<std::uint32_t>(sizes.samples);
    plan.stop = stop;
    std::vector<double> seconds;
    const double all = pixels * static_cast<double>(sizes.samples);
    while (seconds.size() < 3) {
        const RenderOutcome outcome = render(session, plan);
        if (outcome.stopped) return {};
        estimate(outcome.film);
        seconds.push_back(outcome.seconds);
        if (seconds.back() > 5) break;  // long enough not to be repeated
    }
    point.render_seconds = median(seconds);
    point.seconds_per_sample = point.render_seconds / all;
    point.device_bytes = session.device_bytes();
    point.host_bytes = memory_peak();
    return point;
}

GrowthSeries measure_series(const Device& device, const KernelText& kernels,
                            const std::string& what, const std::vector<std::size_t>& wanted,
                            RenderSizes sizes, std::size_t RenderSizes::*grows,
                            const std::function<bool()>& stop) {
    GrowthSeries series;
    series.what = what;
    Progress shown("growth", what);
    for (const std::size_t size : wanted) {
        shown.update(static_cast<double>(series.points.size()), static_cast<double>(wanted.size()));
        sizes.*grows = size;
        try {
            auto point = measure(device, kernels, sizes, stop);
            if (!point) break;
            point->size = size;
            series.points.push_back(*point);
        } catch (const Error& error) {
            if (series.points.empty()) throw;
            series.end = formatted("%zu: ", size) + error.what();
            break;
        }
    }
    return series;
}

}  // namespace

GrowthPlan whole_growth() {
    return {{},
            {1000, 10000, 100000, 1000000, 10000000},
            {1, 10, 100, 1000, 10000},
            {256, 512, 1024, 2048, 4096, 8192},
            {16, 256, 4096, 65536, 1048576}};
}

GrowthPlan short_growth() { return {{1000, 1, 8, 16}, {1000, 4000}, {1, 10}, {16, 32}, {8, 16}}; }

std::vector<GrowthSeries> measure_growth(const Device& device, const KernelText& kernels,
                                         const GrowthPlan& plan,
                                         const std::function<bool()>& stop) {
    RenderSizes few_samples = plan.usual, small_film = plan.usual;
    few_samples.samples = 2;
    small_film.film = 16;
    const struct {
        const char* what;
        const std::vector<std::size_t>& wanted;
        const RenderSizes& others;
        std::size_t RenderSizes::*grows;
    } series[] = {{"triangles", plan.triangles, plan.usual, &RenderSizes::triangles},
                  {"lights", plan.lights, plan.usual, &RenderSizes::lights},
                  {"pixels across", plan.film, few_samples, &RenderSizes::film},
                  {"samples a pixel", plan.samples, small_film, &RenderSizes::samples}};
    std::vector<GrowthSeries> all;
    for (const auto& s : series)
        if (!(stop && stop()))
            all.push_back(
                measure_series(device, kernels, s.what, s.wanted, s.others, s.grows, stop));
    return all;
}

}  // namespace lobe
