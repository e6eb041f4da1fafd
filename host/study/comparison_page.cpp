// SPDX-License-Identifier: Apache-2.0
#include "study/comparison_page.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/statistics.h"
#include "report/chart/histogram.h"
#include "report/chart/interval_chart.h"
#include "study/page_parts.h"

namespace lobe {
namespace {

std::string p_text(double p) { return p < 1e-9 ? "< 1e-9" : shown(p, p < 0.001 ? "%.0e" : "%.3f"); }

// "time, 64 samples of A".
std::string row_name(const ComparisonRow& row) {
    return (row.equal_time ? "time, " : "samples, ") + std::to_string(row.samples_a) +
           (row.equal_time ? " of A" : "");
}

std::string file_name(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

std::string name_of(const SceneComparison& scene) {
    const std::string a = file_name(scene.a.scene), b = file_name(scene.b.scene);
    return a == b ? a : a + " and " + b;
}

// All rows of one judgement, scene by scene and then combined.
struct Judged {
    std::string scene;
    const ComparisonRow* row;
    const Judgement *judgement, *trimmed;
    bool combined;
};

std::vector<Judged> all_judged(const ComparisonReport& report) {
    std::vector<Judged> all;
    for (const SceneComparison& scene : report.scenes)
        for (const ComparisonRow& row : scene.rows)
            all.push_back({name_of(scene), &row, &row.judgement, &row.trimmed, false});
    for (std::size_t r = 0; r < report.combined.size(); ++r)
        all.push_back({"all, geometric mean", &report.scenes.front().rows[r], &report.combined[r],
                       &report.combined_trimmed[r], true});
    return all;
}

ReportTable verdict_table(const ComparisonReport& report) {
    ReportTable table;
    table.title = "B's squared error over A's, at equal time times the time";
    table.head = {"scene",    "at equal", "B / A", "95 %",         "95 %, all scenes", "trimmed",
                  "p (Holm)", "p, ranks", "seeds", "would decide", "verdict"};
    table.csv = {{"scene", "at_equal", "samples_a", "ratio", "lo", "hi", "lo_family", "hi_family",
                  "trimmed_ratio", "p", "p_holm", "wilcoxon_p", "deviation", "seeds",
                  "seeds_needed", "verdict"}};
    for (const Judged& judged : all_judged(report)) {
        const Judgement& j = *judged.judgement;
        const std::string seeds = std::to_string(j.seeds);
        table.rows.push_back(
            {judged.scene, row_name(*judged.row), shown(j.ratio, "%.3f"),
             shown(Interval{j.lo, j.hi}, "%.3f"), shown(Interval{j.lo_family, j.hi_family}, "%.3f"),
             shown(judged.trimmed->ratio, "%.3f"), p_text(j.p_holm), p_text(j.wilcoxon_p), seeds,
             j.seeds_needed ? shown(*j.seeds_needed, "%.0f") : "-", to_text(j.verdict)});
        table.csv.push_back({judged.scene, judged.row->equal_time ? "time" : "samples",
                             std::to_string(judged.row->samples_a), exact(j.ratio), exact(j.lo),
                             exact(j.hi), exact(j.lo_family), exact(j.hi_family),
                             exact(judged.trimmed->ratio), exact(j.p), exact(j.p_holm),
                             exact(j.wilcoxon_p), exact(j.deviation), seeds,
                             j.seeds_needed ? exact(*j.seeds_needed) : "", to_text(j.verdict)});
    }
    if (report.scenes.size() == 1) {  // that column says nothing new
        for (auto& row : table.rows) row.erase(row.begin() + 4);
        table.head.erase(table.head.begin() + 4);
    }
    table.note =
        "Above one A is better. WIN: the interval lies above 1.02 and both p below 0.05; "
        "LOSS: below 0.98; TIE: within. Trimmed: without the worst 0.1 % of the pixels.";
    return table;
}

IntervalChart interval_chart(const ComparisonReport& report) {
    IntervalChart chart;
    chart.title = "How much better A is";
    chart.x_label = "B's squared error (times time) over A's, 95 %";
    for (const Judged& judged : all_judged(report)) {
        const Judgement& j = *judged.judgement;
        const std::string scene = report.scenes.size() > 1 ? judged.scene + ": " : "";
        chart.rows.push_back(
            {scene + row_name(*judged.row), j.lo, j.ratio, j.hi, to_text(j.verdict)});
    }
    return chart;
}

double median_seconds(const std::vector<ComparedRun>& runs) {
    std::vector<double> seconds;
    for (const ComparedRun& run : runs) seconds.push_back(run.seconds);
    return median(seconds);
}

double mean_mse(const std::vector<ComparedRun>& runs) {
    double sum = 0;
    for (const ComparedRun& run : runs) sum += run.error.mse;
    return sum / static_cast<double>(runs.size());
}

std::string error_text(double mse) {
    return mse > 0 ? shown(100 * std::sqrt(mse)) + " %" : "unknown";
}

// The rows of one kind, of all scenes.
ReportTable measured_table(const ComparisonReport& report, bool equal_time) {
    ReportTable table;
    table.title = equal_time ? "Equal time" : "Equal samples";
    table.head = {"scene",   "spp A",   "spp B", "s A",  "s B",
                  "error A", "error B", "B / A", "95 %", "verdict"};
    table.csv = {{"scene", "samples_a", "samples_b", "render_s_a", "render_s_b", "mse_a", "mse_b",
                  "ratio", "lo", "hi", "timing_noise", "verdict"}};
    for (const SceneComparison& scene : report.scenes)
        for (const ComparisonRow& row : scene.rows) {
            if (row.equal_time != equal_time) continue;
            const double a = median_seconds(row.a), b = median_seconds(row.b),
                         mse_a = mean_mse(row.a), mse_b = mean_mse(row.b);
            const Judgement& j = row.judgement;
            const std::string samples_a = std::to_string(row.samples_a),
                              samples_b = std::to_string(row.samples_b);
            table.rows.push_back({name_of(scene), samples_a, samples_b, shown(a), shown(b),
                                  error_text(mse_a), error_text(mse_b), shown(j.ratio, "%.3f"),
                                  shown(Interval{j.lo, j.hi}, "%.3f"), to_text(j.verdict)});
            table.csv.push_back({name_of(scene), samples_a, samples_b, exact(a), exact(b),
                                 exact(mse_a), exact(mse_b), exact(j.ratio), exact(j.lo),
                                 exact(j.hi), exact(row.ratios.timing_noise), to_text(j.verdict)});
            if (!j.reason.empty())
                table.note += "No verdict at " + samples_a + " samples of A: " + j.reason + ". ";
        }
    table.note +=
        "Errors are root mean squares of the luminance over the picture's mean, against "
        "the reference, whose own variance is subtracted. Times are medians.";
    return table;
}

// The log ratios of the last sentence's row, seed by seed.
Histogram ratio_histogram(const ComparisonReport& report) {
    Histogram chart;
    chart.title = "Each seed's ratio";
    chart.x_label =
        "log of B / A, at equal " + row_name(report.scenes.front().rows[headline_row(report)]);
    chart.uniform_band = false;
    double most = 0.01;
    for (const SceneComparison& scene : report.scenes)
        for (const double ratio : scene.rows[headline_row(report)].ratios.log_ratios) {
            if (!std::isfinite(ratio)) continue;
            chart.values.push_back(ratio);
            most = std::max(most, std::abs(ratio));
        }
    chart.high = 1.05 * most;
    chart.low = -chart.high;  // zero, no difference, in the middle
    return chart;
}

Histogram p_histogram(const ComparisonReport& report) {
    Histogram chart;
    chart.title = "Values of p";
    chart.x_label = "p that A and B are equal, by Student's t, not adjusted";
    for (const Judged& judged : all_judged(report))
        if (!judged.combined && judged.judgement->verdict != Verdict::refused)
            chart.values.push_back(judged.judgement->p);
    return chart;
}

ReportSection verdict_section(const ComparisonReport& report) {
    ReportSection section;
    section.heading = "Verdicts";
    section.figures = {
        {draw(interval_chart(report)), "To the right of the line A has less error."},
        {draw(ratio_histogram(report)),
         "Pairs share their seed. Above zero A has less error in that pair."},
        {draw(p_histogram(report)),
         "One for each row. Grey: where 95 % of the counts lie if nothing differs and the rows are "
         "independent, as those of different scenes are."}};
    return section;
}

ReportTable run_table(const ComparisonReport& report) {
    ReportTable table;
    table.title = "Every run";
    table.head = {"scene", "at equal", "runs of A", "runs of B", "s in all"};
    table.csv = csv_rows(to_csv(report));
    table.note = "The CSV holds a line for each run.";
    for (const SceneComparison& scene : report.scenes)
        for (const ComparisonRow& row : scene.rows) {
            double seconds = 0;
            for (const auto* runs : {&row.a, &row.b})
                for (const ComparedRun& run : *runs) seconds += run.seconds;
            table.rows.push_back({name_of(scene), row_name(row), std::to_string(row.a.size()),
                                  std::to_string(row.b.size()), shown(seconds)});
        }
    return table;
}

ReportSection table_section(const ComparisonReport& report) {
    ReportSection section;
    section.heading = "Measured";
    section.tables = {measured_table(report, true), measured_table(report, false),
                      run_table(report)};
    return section;
}

// What an arm was, and its start-up.
ReportSection arm_section(const SceneComparison& scene) {
    ReportSection section;
    section.heading = "A and B: " + name_of(scene);
    std::vector<NamedCosts> costs;
    const ComparisonRow& row = scene.rows.back();
    for (const auto& [name, arm, runs] :
         {std::tuple("A", &scene.a, &row.a), std::tuple("B", &scene.b, &row.b)}) {
        const std::string n = name;
        section.facts.emplace_back(n,
                                   arm->scene + (arm->options.empty() ? "" : "  ") + arm->options);
        section.facts.emplace_back(n + ", sampler", arm->integrator);
        section.facts.emplace_back(n + ", reference",
                                   std::to_string(arm->reference_samples) + " samples a pixel" +
                                       (scene.same_content ? ", the same for both" : ""));
        if (arm->nonfinite)
            section.facts.emplace_back(n + ", samples not finite", std::to_string(arm->nonfinite));
        costs.push_back({n, arm->start_up, median_seconds(*runs)});
    }
    section.facts.emplace_back("Film", std::to_string(scene.width) + " by " +
                                           std::to_string(scene.height) + ", " +
                                           std::to_string(scene.masked) + " pixels left out");
    add_costs(section, "From the command to a picture", costs);
    section.tables.back().note = "Of the last row: equal " + row_name(row) + ".";
    return section;
}

ReportEnvironment environment_of(const ComparisonReport& report) {
    const ComparisonPlan& plan = report.plan;
    ReportEnvironment all;
    all.version = report.version;
    all.device = report.device;
    all.seed = seed_range(plan.first_seed, plan.first_seed + plan.seeds - 1) +
               (plan.own_seeds ? " of A, others of B" : " of both");
    all.command = report.command;
    for (const SceneComparison& scene : report.scenes) {
        const std::string of = report.scenes.size() > 1 ? name_of(scene) + ", " : "";
        all.more.emplace_back(of + "A, content hash", scene.a.content_hash);
        all.more.emplace_back(of + "B, content hash", scene.b.content_hash);
        all.kernels.push_back({of + "A", scene.a.features, scene.a.models});
        all.kernels.push_back({of + "B", scene.b.features, scene.b.models});
    }
    return all;
}

}  // namespace

ReportPage comparison_page(const ComparisonReport& report) {
    ReportPage page;
    page.title = "A or B";
    for (const SceneComparison& scene : report.scenes)
        page.title += (&scene == &report.scenes.front() ? ": " : ", ") + name_of(scene);
    page.headline = verdict_sentence(report);
    page.table = verdict_table(report);
    page.sections = {verdict_section(report), table_section(report)};
    for (const SceneComparison& scene : report.scenes) page.sections.push_back(arm_section(scene));
    page.environment = environment_of(report);
    return page;
}

}  // namespace lobe
