// SPDX-License-Identifier: Apache-2.0
#include "study/convergence_fit.h"

#include <cmath>

#include "base/statistics.h"

namespace lobe {
namespace {

// The runs as a table: [level][seed].
struct Runs {
    std::vector<double> samples;
    std::vector<std::vector<double>> mse, seconds;
};

Runs table_of(const ConvergenceReport& report) {
    Runs runs;
    const std::size_t levels = report.levels.size();
    runs.mse.resize(levels);
    runs.seconds.resize(levels);
    for (const ConvergenceLevel& level : report.levels)
        runs.samples.push_back(static_cast<double>(level.samples));
    for (const ConvergenceRun& run : report.runs) {
        runs.mse[run.level].push_back(run.mse);
        runs.seconds[run.level].push_back(run.seconds);
    }
    return runs;
}

struct Fits {
    std::vector<Studentised> mse;
    LineFit power, floor;
    double seconds_per_sample = 0, overhead = 0;
};

// From the chosen seeds.
Fits fit_chosen(const Runs& runs, const std::vector<std::size_t>& chosen) {
    Fits fits;
    std::vector<double> inverse, logs, log_errors, mse, variance, log_variance, seconds;
    std::vector<double> values(chosen.size()), times(chosen.size());
    for (std::size_t k = 0; k < runs.samples.size(); ++k) {
        for (std::size_t i = 0; i < chosen.size(); ++i) values[i] = runs.mse[k][chosen[i]];
        for (std::size_t i = 0; i < chosen.size(); ++i) times[i] = runs.seconds[k][chosen[i]];
        const Studentised m = studentised_mean(values);
        fits.mse.push_back(m);
        inverse.push_back(1 / runs.samples[k]);
        logs.push_back(std::log(runs.samples[k]));
        log_errors.push_back(0.5 * std::log(m.value));
        mse.push_back(m.value);
        variance.push_back(m.error * m.error);
        log_variance.push_back(std::pow(0.5 * m.error / m.value, 2));
        seconds.push_back(median(times));
    }
    fits.power = fit_line(logs, log_errors, log_variance);
    fits.floor = fit_line(inverse, mse, variance);
    fits.seconds_per_sample = theil_sen_slope(runs.samples, seconds);
    fits.overhead = theil_sen_intercept(runs.samples, seconds, fits.seconds_per_sample);
    return fits;
}

void fill_bands(ConvergenceReport& report, const Runs& runs) {
    BootstrapOptions options;
    options.resamples = report.plan.resamples;
    const auto figures = [&](const std::vector<std::size_t>& chosen) {
        const Fits f = fit_chosen(runs, chosen);
        std::vector<Studentised> all = f.mse;
        all.push_back({f.power.slope, f.power.slope_error});
        all.push_back({f.floor.slope, f.floor.slope_error});
        all.push_back({f.floor.intercept, f.floor.intercept_error});
        all.push_back(
            {f.floor.slope * f.seconds_per_sample, f.floor.slope_error * f.seconds_per_sample});
        return all;
    };
    const std::vector<Interval> bands = bootstrap(report.seeds, figures, options);
    const std::size_t levels = report.levels.size();
    for (std::size_t k = 0; k < levels; ++k) report.levels[k].mse_band = bands[k];
    report.fit.slope_band = bands[levels];
    report.fit.v_band = bands[levels + 1];
    report.fit.b2_band = bands[levels + 2];
    report.fit.unit_variance_band = bands[levels + 3];
}

}  // namespace

double reference_floor_variance(const Reference& reference, const std::vector<bool>& masked) {
    double fourth = 0, pixels = 0;
    for (std::size_t p = 0; p < masked.size(); ++p) {
        if (masked[p]) continue;
        fourth += std::pow(static_cast<double>(reference.luminance_error[p]), 4);
        ++pixels;
    }
    return 2.0 * LOBE_REPLICATES / (LOBE_REPLICATES + 1) * fourth / (pixels * pixels);
}

void fit_levels(ConvergenceReport& report, double floor_variance) {
    const Runs runs = table_of(report);
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < report.seeds; ++i) all.push_back(i);
    const Fits fits = fit_chosen(runs, all);
    ConvergenceFit& fit = report.fit;
    fit.power = fits.power;
    fit.floor = fits.floor;
    fit.b2_error = std::sqrt(std::pow(fit.floor.intercept_error, 2) + floor_variance);
    // The weights are estimates too: Student's law with the freedom of each.
    fit.b2_p = 2 * student_cdf(-std::fabs(fit.floor.intercept) / fit.b2_error,
                               static_cast<double>(report.seeds) - 1);
    fit.seconds_per_sample = fits.seconds_per_sample;
    fit.overhead = fits.overhead;
    fit.unit_variance_seconds = fit.floor.slope * fit.seconds_per_sample;
    const double wanted = std::log(report.plan.target * report.reference_mean);
    fit.target_samples = std::exp((wanted - fit.power.intercept) / fit.power.slope);
    fit.target_seconds = fit.seconds_per_sample * fit.target_samples + std::fmax(0, fit.overhead);
    fill_bands(report, runs);
}

}  // namespace lobe
