// SPDX-License-Identifier: Apache-2.0
#include "study/convergence_level.h"

#include <cmath>

#include "base/luminance.h"
#include "base/statistics.h"
#include "report/metrics.h"

namespace lobe {
namespace {

constexpr double least_freedom = 30;  // of the deviations that a tail is measured in

double squared(double x) { return x * x; }

// One figure of all runs of a level.
std::vector<double> values(const std::vector<ConvergenceRun>& runs, unsigned level,
                           double ConvergenceRun::*figure) {
    std::vector<double> result;
    for (const ConvergenceRun& run : runs)
        if (run.level == level) result.push_back(run.*figure);
    return result;
}

// Bias of the mean picture. Its pixels are independent, so that their spread tells the standard
// error of the mean of their bias squared, the reference's share included.
void fill_bias(ConvergenceLevel& level, const LevelSums& sums, const Reference& reference,
               const std::vector<bool>& masked) {
    std::vector<double> squares;
    double difference = 0, variance = 0;
    for (std::size_t p = 0; p < masked.size(); ++p) {
        if (masked[p]) continue;
        const double d = sums.mean(p) - luminance(&reference.rgb[3 * p]);
        const double v = sums.variance(p) / sums.count() + squared(reference.luminance_error[p]);
        squares.push_back(d * d - v);
        difference += d;
        variance += v;
    }
    const auto pixels = static_cast<double>(squares.size());
    level.bias_squared = studentised_mean(squares);
    level.mean_difference = {difference / pixels, std::sqrt(variance) / pixels};
}

}  // namespace

LevelSums::LevelSums(std::uint32_t samples, std::size_t pixels)
    : samples_(samples), sums_(pixels), squares_(pixels) {}

void LevelSums::add(const Estimate& picture) {
    if (count_ == 0)
        for (std::size_t p = 0; p < sums_.size(); ++p)
            origin_.push_back(static_cast<float>(luminance(&picture.rgb[3 * p])));
    for (std::size_t p = 0; p < sums_.size(); ++p) {
        const double value = luminance(&picture.rgb[3 * p]);
        sums_[p] += value;
        squares_[p] += squared(value - origin_[p]);
    }
    ++count_;
}

double LevelSums::variance(std::size_t pixel) const {
    const double shift = mean(pixel) - origin_[pixel];
    return std::fmax(0, squares_[pixel] - count_ * shift * shift) / (count_ - 1);
}

ConvergenceRun measure_run(const ArmRun& run, const Reference& reference,
                           const std::vector<bool>& masked) {
    MetricsOptions options;
    options.left_out = &masked;
    const PictureMetrics metrics =
        compare_pictures(view_of(run.picture), view_of(reference), options);
    ConvergenceRun result;
    result.seed = run.seed;
    result.samples = run.samples;
    result.seconds = run.seconds;
    result.hash = image_hash(run.picture);
    if (metrics.channels.size() < 4) return result;
    const ChannelMetrics& light = metrics.channels[0];
    result.mse = light.mse.value_or(light.mse_raw);
    for (std::size_t c = 0; c < 3; ++c)
        result.rgb[c] = metrics.channels[c + 1].mse.value_or(metrics.channels[c + 1].mse_raw);
    result.bias_squared = light.bias_squared.value_or(result.mse);
    result.mse0 = result.mse - result.bias_squared;
    result.mse_trimmed = light.mse_trimmed;
    result.relmse = light.relmse.value_or(light.relmse_raw);
    result.relmse_trimmed = light.relmse_trimmed;
    result.smape = light.smape;
    result.p99 = light.p99;
    result.max = light.max;
    return result;
}

ConvergenceLevel measure_level(const LevelSums& sums, const std::vector<ConvergenceRun>& runs,
                               unsigned level, const Reference& reference,
                               const std::vector<bool>& masked) {
    ConvergenceLevel result;
    result.samples = sums.samples();
    const std::vector<double> seconds = values(runs, level, &ConvergenceRun::seconds);
    result.seconds = median(seconds);
    result.seconds_deviation = deviation_from(seconds, result.seconds);
    result.mse = studentised_mean(values(runs, level, &ConvergenceRun::mse));
    result.mse0 = studentised_mean(values(runs, level, &ConvergenceRun::mse0));
    result.relmse = studentised_mean(values(runs, level, &ConvergenceRun::relmse));
    result.mse_trimmed = mean(values(runs, level, &ConvergenceRun::mse_trimmed));
    result.relmse_trimmed = mean(values(runs, level, &ConvergenceRun::relmse_trimmed));
    result.smape = mean(values(runs, level, &ConvergenceRun::smape));
    result.efficiency = 1 / (result.mse.value * result.seconds);
    fill_bias(result, sums, reference, masked);
    return result;
}

std::optional<TailIndex> error_tail(const std::vector<std::vector<float>>& pictures,
                                    const std::vector<LevelSums>& sums, const Reference& reference,
                                    const std::vector<bool>& masked) {
    // Too rough a deviation has a heavy tail of its own.
    const double freedom = double(sums.size() - 1) * (double(pictures.size()) - 1);
    if (freedom < least_freedom) return {};
    std::vector<double> errors;
    for (std::size_t p = 0; p < masked.size(); ++p) {
        if (masked[p]) continue;
        double variance = 0;  // of one sample, the mean over the other levels
        for (std::size_t k = 1; k < sums.size(); ++k)
            variance += sums[k].samples() * sums[k].variance(p) / double(sums.size() - 1);
        const double truth = luminance(&reference.rgb[3 * p]);
        const double deviation = std::sqrt(variance / sums[0].samples());
        for (const auto& picture : pictures)
            errors.push_back(std::fabs(picture[p] - truth) / deviation);
    }
    return tail_index(std::move(errors));
}

}  // namespace lobe
