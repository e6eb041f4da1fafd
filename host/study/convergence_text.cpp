// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>

#include "base/format.h"
#include "base/progress.h"
#include "base/statistics.h"
#include "report/sparkline.h"
#include "report/text_table.h"
#include "study/convergence_report.h"

namespace lobe {
namespace {

std::string number(double value, const char* pattern = "%.3g") {
    if (!std::isfinite(value)) return "-";
    char text[64];
    std::snprintf(text, sizeof text, pattern, value);
    return text;
}

std::string interval(const Interval& band, const char* pattern = "%.3g") {
    if (std::isnan(band.low)) return "";
    return " (95 %: " + number(band.low, pattern) + " to " + number(band.high, pattern) + ")";
}

std::string percent(double part) { return number(100 * part) + " %"; }

std::string sampler_name(const Integrator& integrator) {
    return integrator.sampler == Integrator::Sampler::independent ? "independent" : "sobol";
}

std::string reference_line(const ConvergenceReport& r) {
    std::string line = "reference  ";
    if (r.reference.samples) line += formatted("%u samples a pixel, ", r.reference.samples);
    line += r.reference.from_cache    ? "from the cache"
            : r.reference.seconds > 0 ? "rendered now"
                                      : r.reference.file;
    const double last = r.levels.empty() ? 0 : r.levels.back().mse.value;
    if (r.reference_variance == 0)
        line += "; taken to be exact";
    else if (last > 0)
        line += formatted("; its variance, 1/%.3g of the last MSE, is subtracted",
                          last / r.reference_variance);
    return line + "\n";
}

std::string mask_line(const ConvergenceReport& r) {
    if (!r.plan.mask) return "mask       none\n";
    return formatted(
        "mask       %zu of %.0f pixels, in which a light is seen directly, and their neighbours, "
        "are "
        "left out\n",
        r.masked, static_cast<double>(r.width) * r.height);
}

std::string level_table(const ConvergenceReport& r) {
    TextTable table({"spp", "seconds", "error %", "MSE", "+-", "trimmed", "MSE0", "bias^2", "+-",
                     "relMSE", "trimmed", "SMAPE", "1/(MSE s)"});
    for (const ConvergenceLevel& l : r.levels)
        table.add({std::to_string(l.samples), number(l.seconds),
                   number(100 * relative_error(r, l.mse.value)), number(l.mse.value, "%.4g"),
                   number(l.mse.error, "%.1g"), number(l.mse_trimmed), number(l.mse0.value, "%.4g"),
                   number(l.bias_squared.value, "%.2g"), number(l.bias_squared.error, "%.1g"),
                   number(l.relmse.value), number(l.relmse_trimmed), number(l.smape),
                   number(l.efficiency)});
    return table.text();
}

std::string spark(const ConvergenceReport& r) {
    std::vector<double> errors;
    for (const ConvergenceLevel& l : r.levels) errors.push_back(l.mse.value);
    return sparkline(errors, SparkScale::logarithmic);
}

// Time from the command to the target, with the parts of the start-up by name.
std::string time_lines(const ConvergenceReport& r) {
    const StartUp& s = r.start_up;
    const ConvergenceFit& f = r.fit;
    std::string text = formatted(
        "start-up   %.3g s: parse %.3g, bvh %.3g, compile %.3g (again %.3g%s), upload %.3g\n",
        s.total(), s.parse, s.bvh, s.compile, r.compile_again,
        r.compile_cold ? formatted(", cold %.3g", *r.compile_cold).c_str() : "", s.upload);
    text += "time       " + number(f.seconds_per_sample) + " s a sample of every pixel, " +
            number(std::fmax(0, f.overhead)) + " s a render; to unit variance " +
            number(f.unit_variance_seconds) + " s" + interval(f.unit_variance_band) + "\n";
    const double warm = s.total() - s.compile + r.compile_again;
    text += "target     " + percent(r.plan.target) + ": ";
    if (!std::isfinite(f.target_seconds)) return text + "unknown\n";
    text += number(f.target_samples) + " samples, " + number(f.target_seconds) +
            " s; with start-up " + number(s.total() + f.target_seconds) + " s, " +
            number(warm + f.target_seconds) + " s when compiled before";
    const bool beyond =
        f.target_samples > r.levels.back().samples || f.target_samples < r.levels.front().samples;
    return text + (beyond ? " (beyond what was measured)\n" : "\n");
}

std::string fit_lines(const ConvergenceReport& r) {
    const ConvergenceFit& f = r.fit;
    std::string text = "slope      " + number(f.power.slope, "%.4f") + " +- " +
                       number(f.power.slope_error, "%.2g") + interval(f.slope_band, "%.4f") +
                       "; -1/2 is that of independent samples, these are " +
                       sampler_name(r.integrator) + "  " + spark(r) + "\n";
    text += "fit        MSE = v/N + b2: v " + number(f.floor.slope, "%.4g") + " +- " +
            number(f.floor.slope_error, "%.1g") + ", b2 " + number(f.floor.intercept, "%.2g") +
            " +- " + number(f.b2_error, "%.1g") + ", p of no b2 " + number(f.b2_p, "%.2g") +
            ", p of the fit " + number(f.floor.p(), "%.2g") + "\n";
    if (r.tail)
        text +=
            "tail       index " + number(r.tail->alpha, "%.1f") + " +- " +
            number(r.tail->error, "%.1f") + ": " +
            (r.tail->heavy() ? "below 2, the variance may be infinite" : "the variance is finite") +
            "\n";
    return text + "bias       " + judge_bias(r).sentence + "\n";
}

double deviations(const Studentised& figure) {
    return figure.error > 0 ? figure.value / figure.error : 0;
}

}  // namespace

BiasVerdict judge_bias(const ConvergenceReport& r) {
    BiasVerdict verdict;
    if (r.levels.empty()) return verdict;
    const ConvergenceLevel& last = r.levels.back();
    verdict.mean_z = deviations(last.mean_difference);
    verdict.squared_z = deviations(last.bias_squared);
    if (std::isfinite(r.fit.b2_error))
        verdict.floor_z = deviations({r.fit.floor.intercept, r.fit.b2_error});
    verdict.floor_counts = r.integrator.sampler == Integrator::Sampler::independent;
    const double level = sidak(0.003, verdict.floor_counts ? 3 : 2);
    // Squares lie above zero by a bias only.
    const bool by_mean = two_sided_p(verdict.mean_z) < level;
    const bool by_square = normal_cdf(-verdict.squared_z) < level;
    const bool by_floor = verdict.floor_counts && r.fit.floor.intercept > 0 && r.fit.b2_p < level;
    verdict.found = by_mean || by_square || by_floor;
    verdict.sentence = verdict.found ? "FOUND" : "none found";
    verdict.sentence +=
        formatted(": image mean %+.3g %% +- %.2g %%%s, bias^2 at %u samples %.1f standard errors%s",
                  100 * last.mean_difference.value / r.reference_mean,
                  100 * last.mean_difference.error / r.reference_mean, by_mean ? " (!)" : "",
                  last.samples, verdict.squared_z, by_square ? " (!)" : "");
    if (verdict.floor_counts)
        verdict.sentence += formatted(", b2 %.1f%s", verdict.floor_z, by_floor ? " (!)" : "");
    return verdict;
}

std::string to_text(const ConvergenceReport& r) {
    std::string text = formatted("scene      %s, %ux%u, %s\n", r.path.c_str(), r.width, r.height,
                                 r.device.name.c_str());
    text += "sampler    " + to_text(r.integrator) + "\n";
    text += reference_line(r) + mask_line(r);
    text += formatted("renders    %u of %u seeds from %llu; 95 %% bands by bootstrap over seeds\n",
                      r.seeds, r.plan.seeds, static_cast<unsigned long long>(r.plan.first_seed));
    if (r.levels.empty())
        return text + (r.masked == static_cast<std::size_t>(r.width) * r.height
                           ? "no pixel is left to compare: --no-mask compares all\n"
                           : "too few for any figure: at least 3 seeds are needed\n");
    text += "\n" + level_table(r) + "\n";
    text += formatted(
        "relMSE adds epsilon = %.3g to R^2; trimmed: without the worst 0.1 %% of pixels\n",
        r.relmse_epsilon);
    return text + fit_lines(r) + time_lines(r);
}

std::string summary_text(const std::vector<ConvergenceReport>& reports) {
    TextTable table({"scene", "sampler", "slope", "+-", "v / mean^2", "bias", "s/sample",
                     "s to unit variance", "s to target", "with start-up"});
    for (const ConvergenceReport& r : reports) {
        if (r.levels.empty()) continue;
        const ConvergenceFit& f = r.fit;
        table.add({r.path, sampler_name(r.integrator), number(f.power.slope, "%.3f"),
                   number(f.power.slope_error, "%.1g"),
                   number(f.floor.slope / (r.reference_mean * r.reference_mean)),
                   judge_bias(r).found ? "FOUND" : "none", number(f.seconds_per_sample),
                   number(f.unit_variance_seconds), number(f.target_seconds),
                   number(r.start_up.total() + f.target_seconds)});
    }
    return table.text();
}

}  // namespace lobe
