// SPDX-License-Identifier: Apache-2.0
#include "study/convergence_page.h"

#include <algorithm>
#include <cmath>

#include "report/chart/line_chart.h"
#include "report/html/pictures.h"
#include "study/page_parts.h"

namespace lobe {
namespace {

constexpr std::uint32_t most_shown = 700;  // pixels of a reference, in width and height

using Reports = std::vector<const ConvergenceReport*>;

std::string percent(double part) { return shown(100 * part) + " %"; }

std::string name_of(const ConvergenceReport& r) {
    const std::string name = r.path.substr(r.path.find_last_of('/') + 1);
    return name.substr(0, name.rfind(".pbrt"));
}

double error_of(const ConvergenceReport& r, double mse) {
    return relative_error(r, std::max(mse, 0.0));
}

// The error of every level against its samples, or its time.
LineChart error_chart(const Reports& reports, bool against_time) {
    LineChart chart;
    chart.title = against_time ? "Error against time" : "Error against samples";
    chart.x_label = against_time ? "rendering time (s)" : "samples a pixel";
    chart.y_label = "relative error";
    chart.guide_slope = -0.5;
    chart.level = reports.front()->plan.target;
    for (const ConvergenceReport* r : reports) {
        ChartSeries series;
        series.label = name_of(*r);
        for (const ConvergenceLevel& l : r->levels) {
            series.points.push_back(
                {against_time ? l.seconds : l.samples, error_of(*r, l.mse.value)});
            series.band.push_back({error_of(*r, l.mse_band.low), error_of(*r, l.mse_band.high)});
        }
        chart.series.push_back(series);
    }
    return chart;
}

ReportSection error_section(const Reports& reports) {
    ReportSection section;
    section.heading = "Error against samples and time";
    section.figures = {
        {draw(error_chart(reports, false)),
         "Root of the mean squared error of the luminance over the reference's mean, with bands of "
         "95 % (bootstrap over seeds). Dashed: the slope -1/2 of independent samples, and the "
         "target."},
        {draw(error_chart(reports, true)),
         "The same against the median time of a render, without start-up."}};
    return section;
}

ReportTable level_table(const ConvergenceReport& r) {
    ReportTable table;
    table.title = "At equal samples: " + name_of(r);
    table.head = {"samples", "seconds", "error",   "MSE",    "95 %",  "MSE, trimmed",
                  "MSE0",    "bias²",   "± bias²", "relMSE", "SMAPE", "1 / (MSE s)"};
    table.csv = {{"spp", "wall_s", "relative_error", "mse", "mse_low", "mse_high", "mse_trim",
                  "mse0", "bias2", "bias2_se", "relmse", "smape", "efficiency_per_s"}};
    for (const ConvergenceLevel& l : r.levels) {
        const double error = relative_error(r, l.mse.value);
        table.rows.push_back({std::to_string(l.samples), shown(l.seconds), percent(error),
                              shown(l.mse.value), shown(l.mse_band), shown(l.mse_trimmed),
                              shown(l.mse0.value), shown(l.bias_squared.value, "%.2g"),
                              shown(l.bias_squared.error, "%.1g"), shown(l.relmse.value),
                              shown(l.smape), shown(l.efficiency)});
        std::vector<std::string> digits = {std::to_string(l.samples)};
        for (const double value : {l.seconds, error, l.mse.value, l.mse_band.low, l.mse_band.high,
                                   l.mse_trimmed, l.mse0.value, l.bias_squared.value,
                                   l.bias_squared.error, l.relmse.value, l.smape, l.efficiency})
            digits.push_back(exact(value));
        table.csv.push_back(digits);
    }
    table.note =
        "Errors are of luminance, with the reference's own variance subtracted. MSE0: the part "
        "that is noise, from the pictures alone; bias²: what is left in the mean of all seeds, and "
        "its standard error. Trimmed: without the worst 0.1 % of the pixels. relMSE adds " +
        shown(r.relmse_epsilon) + " to the squared reference.";
    return table;
}

ReportFacts fit_facts(const ConvergenceReport& r) {
    const ConvergenceFit& f = r.fit;
    ReportFacts facts = {{"Slope of the error", shown(f.power.slope, "%.4f") + " ± " +
                                                    shown(f.power.slope_error, "%.2g") +
                                                    " (95 %: " + shown(f.slope_band, "%.4f") + ")"},
                         {"v, the variance of a sample", shown(f.floor.slope, "%.4g") + " ± " +
                                                             shown(f.floor.slope_error, "%.1g") +
                                                             " (95 %: " + shown(f.v_band) + ")"},
                         {"b², the error that stays",
                          shown(f.floor.intercept, "%.2g") + " ± " + shown(f.b2_error, "%.1g") +
                              " (95 %: " + shown(f.b2_band, "%.2g") + ")"},
                         {"p that b² is 0", shown(f.b2_p, "%.2g")},
                         {"p of the fit", shown(f.floor.p(), "%.2g")},
                         {"Bias", judge_bias(r).sentence}};
    if (r.tail)
        facts.emplace_back("Tail index of the errors",
                           shown(r.tail->alpha, "%.1f") + " ± " + shown(r.tail->error, "%.1f") +
                               (r.tail->heavy() ? ", below 2: the variance may be infinite" : ""));
    return facts;
}

ReportFacts time_facts(const ConvergenceReport& r) {
    const ConvergenceFit& f = r.fit;
    ReportFacts facts = {
        {"A sample of every pixel", shown(f.seconds_per_sample) + " s"},
        {"Once a render", shown(std::max(f.overhead, 0.0)) + " s"},
        {"To unit variance",
         shown(f.unit_variance_seconds) + " s (95 %: " + shown(f.unit_variance_band) + ")"},
        {"To an error of " + percent(r.plan.target),
         shown(f.target_samples) + " samples, " + shown(f.target_seconds) + " s; with start-up " +
             shown(r.start_up.total() + f.target_seconds) + " s"},
        {"Compiled again", shown(r.compile_again) + " s, with what the first time left in caches"}};
    if (r.compile_cold)
        facts.emplace_back("Compiled without any cache", shown(*r.compile_cold) + " s");
    return facts;
}

ReportSection level_section(const ConvergenceReport& r) {
    ReportSection section;
    section.heading = "Levels and fit: " + name_of(r);
    section.facts = fit_facts(r);
    section.paragraphs = {
        "Fitted is MSE = v / N + b² over the samples N. A slope of -1/2 is that "
        "of independent samples; these are " +
        to_text(r.integrator) + "."};
    section.paragraphs.insert(section.paragraphs.end(), r.warnings.begin(), r.warnings.end());
    section.tables = {level_table(r)};
    return section;
}

ReportSection time_section(const ConvergenceReport& r) {
    ReportSection section;
    section.heading = "Where the time goes: " + name_of(r);
    section.facts = time_facts(r);
    std::vector<NamedCosts> costs;
    for (const ConvergenceLevel* level : {&r.levels.front(), &r.levels.back()})
        costs.push_back({std::to_string(level->samples) + " samples", r.start_up, level->seconds});
    if (std::isfinite(r.fit.target_seconds))
        costs.push_back({percent(r.plan.target) + " error", r.start_up, r.fit.target_seconds});
    add_costs(section, "From the command to a picture", costs);
    return section;
}

ReportSection reference_section(const ConvergenceReport& r) {
    ReportSection section;
    section.heading = "Reference: " + name_of(r);
    const Reference& reference = r.reference;
    const std::string pixels = std::to_string(std::size_t{r.width} * r.height);
    section.facts = {
        {"Samples a pixel", reference.samples ? std::to_string(reference.samples) : "unknown"},
        {"Mean luminance", shown(r.reference_mean, "%.6g")},
        {"Its own variance", shown(r.reference_variance)},
        {"Pixels left out", std::to_string(r.masked) + " of " + pixels}};
    if (reference.from_cache) section.facts.emplace_back("From", reference.file);
    if (reference.rgb.size() != 3 * std::size_t{r.width} * r.height) return section;
    const PictureView view = view_of(reference);
    ReportViewer viewer;
    viewer.pictures = {linear_picture("reference", view)};
    if (reference.standard_error.size() == reference.rgb.size())
        viewer.pictures.push_back(standard_error_picture("standard error", view));
    const std::uint32_t width = std::min(r.width, most_shown),
                        height = std::min(r.height, most_shown);
    for (ReportPicture& p : viewer.pictures)
        p.image = cropped(p.image, (r.width - width) / 2, (r.height - height) / 2, width, height);
    viewer.caption = std::to_string(r.width) + " by " + std::to_string(r.height) + " pixels";
    if (width < r.width || height < r.height) viewer.caption += "; shown is the middle";
    if (r.reference_mean > 0) viewer.exposure = std::clamp(0.2 / r.reference_mean, 0.1, 10.0);
    section.viewers = {viewer};
    return section;
}

ReportTable headline_table(const Reports& reports) {
    ReportTable table;
    table.title = "What each scene came to";
    table.head = {"scene",
                  "slope",
                  "v / mean²",
                  "bias",
                  "s a sample",
                  "s to unit variance",
                  "s to " + percent(reports.front()->plan.target),
                  "with start-up"};
    table.csv = {{"scene", "slope", "v_over_mean2", "bias", "c_s_per_sample", "ttuv_s",
                  "target_render_s", "target_total_s"}};
    for (const ConvergenceReport* r : reports) {
        const ConvergenceFit& f = r->fit;
        const double noise = f.floor.slope / (r->reference_mean * r->reference_mean);
        const std::string bias = judge_bias(*r).found ? "FOUND" : "none found";
        const double total = r->start_up.total() + f.target_seconds;
        table.rows.push_back(
            {name_of(*r), shown(f.power.slope, "%.3f") + " ± " + shown(f.power.slope_error, "%.1g"),
             shown(noise), bias, shown(f.seconds_per_sample), shown(f.unit_variance_seconds),
             shown(f.target_seconds), shown(total)});
        table.csv.push_back({r->path, exact(f.power.slope), exact(noise), bias,
                             exact(f.seconds_per_sample), exact(f.unit_variance_seconds),
                             exact(f.target_seconds), exact(total)});
    }
    return table;
}

std::string headline(const Reports& reports) {
    if (reports.empty()) return "Too few renders were complete for any figure.";
    const ConvergenceReport& r = *reports.front();
    std::string text = std::isfinite(r.fit.target_seconds)
                           ? "An error of " + percent(r.plan.target) + " takes " +
                                 shown(r.fit.target_samples) + " samples a pixel and " +
                                 shown(r.fit.target_seconds) + " s of rendering"
                           : "The time to an error of " + percent(r.plan.target) + " is not known";
    if (reports.size() > 1) text += ", in " + name_of(r);
    return text + "; the error falls as samples to the power of " +
           shown(r.fit.power.slope, "%.3f") + ", bias: " + judge_bias(r).sentence + ".";
}

// A row a level here, a line a render in its CSV, which is that of --csv.
ReportTable render_table(const ConvergenceResults& results) {
    ReportTable table;
    table.title = "Every render";
    table.head = {"scene", "samples", "renders", "samples not finite", "negative"};
    table.csv = csv_rows(to_csv(results));
    table.note = "The CSV holds a line for each render.";
    for (const ConvergenceReport& r : results.scenes)
        for (const ConvergenceLevel& level : r.levels) {
            std::uint64_t count = 0, nonfinite = 0, negative = 0;
            for (const ConvergenceRun& run : r.runs) {
                if (run.samples != level.samples) continue;
                ++count;
                nonfinite += run.nonfinite;
                negative += run.negative;
            }
            table.rows.push_back({name_of(r), std::to_string(level.samples), std::to_string(count),
                                  std::to_string(nonfinite), std::to_string(negative)});
        }
    return table;
}

ReportEnvironment environment_of(const ConvergenceResults& results) {
    const ConvergenceReport& first = results.scenes.front();
    ReportEnvironment all;
    all.version = results.version;
    all.device = first.device;
    std::uint64_t last = first.plan.first_seed;
    for (const ConvergenceReport& r : results.scenes)
        for (const ConvergenceRun& run : r.runs) last = std::max(last, run.seed);
    all.seed = seed_range(first.plan.first_seed, last) + ": " + std::to_string(first.seeds) +
               " of each level, 64 apart";
    all.command = results.command;
    for (const ConvergenceReport& r : results.scenes) {
        all.more.emplace_back("Scene", r.path);
        all.more.emplace_back("Content hash", r.content_hash);
        all.more.emplace_back("Film", std::to_string(r.width) + " by " + std::to_string(r.height));
        all.more.emplace_back("Sampler", to_text(r.integrator));
        if (r.stopped)
            all.more.emplace_back("Stopped", "after " + std::to_string(r.seeds) + " of " +
                                                 std::to_string(r.plan.seeds) + " seeds");
        all.kernels.push_back({results.scenes.size() > 1 ? name_of(r) : "", r.features, r.models});
    }
    return all;
}

}  // namespace

ReportPage convergence_page(const ConvergenceResults& results) {
    Reports measured;
    for (const ConvergenceReport& report : results.scenes)
        if (!report.levels.empty()) measured.push_back(&report);
    ReportPage page;
    page.title = "Error against run time";
    for (const ConvergenceReport& report : results.scenes)
        page.title += (&report == &results.scenes.front() ? ": " : ", ") + name_of(report);
    page.headline = headline(measured);
    if (!measured.empty()) {
        page.table = headline_table(measured);
        page.sections = {error_section(measured)};
    }
    for (const ConvergenceReport* report : measured) {
        page.sections.push_back(level_section(*report));
        page.sections.push_back(time_section(*report));
    }
    for (const ConvergenceReport& report : results.scenes)
        page.sections.push_back(reference_section(report));
    if (!measured.empty()) page.sections.push_back({"Renders", {}, {}, {}, {}, {}});
    if (!measured.empty()) page.sections.back().tables = {render_table(results)};
    page.environment = environment_of(results);
    return page;
}

}  // namespace lobe
