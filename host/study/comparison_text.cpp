// SPDX-License-Identifier: Apache-2.0
// `lobe compare` in words.
#include <cmath>
#include <cstdio>

#include "base/format.h"
#include "base/statistics.h"
#include "report/text_table.h"
#include "study/comparison_report.h"

namespace lobe {
namespace {

std::string p_text(double p) {
    return p < 1e-9 ? "< 1e-9" : formatted(p < 0.001 ? "%.0e" : "%.3f", p);
}

std::string ratio_text(const Judgement& j) {
    return std::isfinite(j.ratio) ? formatted("%.3f", j.ratio) : "-";
}

std::string interval_text(const Judgement& j) {
    return std::isfinite(j.lo) ? formatted("%.3f to %.3f", j.lo, j.hi) : "-";
}

// Root mean square over seeds, relative to the picture's mean.
std::string error_text(const std::vector<ComparedRun>& runs) {
    double sum = 0;
    for (const ComparedRun& run : runs) sum += run.error.mse;
    const double square = sum / static_cast<double>(runs.size());
    return square > 0 ? formatted("%.3g %%", 100 * std::sqrt(square)) : "unknown";
}

std::string seconds_text(const std::vector<ComparedRun>& runs) {
    std::vector<double> seconds;
    for (const ComparedRun& run : runs) seconds.push_back(run.seconds);
    return formatted("%.3g", median(seconds));
}

std::string verdict_text(const Judgement& j) {
    std::string verdict = to_text(j.verdict);
    if (j.seeds_needed) verdict += formatted(" (%.0f seeds)", *j.seeds_needed);
    return verdict;
}

const std::vector<std::string> head = {"at equal", "spp A",   "spp B",  "s A",  "s B",
                                       "error A",  "error B", "B/A",    "95 %", "p",
                                       "p ranks",  "trimmed", "verdict"};

std::string row_name(const ComparisonRow& row) { return row.equal_time ? "time" : "samples"; }

std::string scene_table(const SceneComparison& scene) {
    TextTable table(head);
    for (const ComparisonRow& row : scene.rows) {
        const Judgement& j = row.judgement;
        table.add({row_name(row), formatted("%u", row.samples_a), formatted("%u", row.samples_b),
                   seconds_text(row.a), seconds_text(row.b), error_text(row.a), error_text(row.b),
                   ratio_text(j), interval_text(j), p_text(j.p_holm), p_text(j.wilcoxon_p),
                   ratio_text(row.trimmed), verdict_text(j)});
    }
    return table.text();
}

std::string arm_line(const char* name, const ComparedArm& arm) {
    return std::string(name) + "  " + arm.scene + (arm.options.empty() ? "" : "  " + arm.options) +
           "\n   " + arm.integrator + "\n";
}

std::string scene_text(const SceneComparison& scene) {
    std::string all = arm_line("A", scene.a) + arm_line("B", scene.b);
    all += formatted("%ux%u pixels", scene.width, scene.height);
    all += scene.masked ? formatted(", %zu that see a light directly, or are next to one, left out",
                                    scene.masked)
                        : ", none that sees a light directly";
    all += formatted("; reference: %u samples", scene.a.reference_samples);
    all += scene.same_content ? ", the same for both\n" : " each\n";
    all += scene_table(scene);
    for (const ComparisonRow& row : scene.rows)
        if (!row.judgement.reason.empty())
            all += "no verdict at equal " + row_name(row) + ", " + formatted("%u", row.samples_a) +
                   " samples of A: " + row.judgement.reason + "\n";
    for (const auto& [name, arm] : {std::pair("A", scene.a), std::pair("B", scene.b)})
        if (arm.nonfinite)
            all += formatted("warning: %u samples of %s were not finite and count as black\n",
                             arm.nonfinite, name);
    return all;
}

std::string combined_table(const ComparisonReport& report) {
    TextTable table({"at equal", "spp A", "B/A", "95 %", "p", "p ranks", "trimmed", "verdict"});
    for (std::size_t r = 0; r < report.combined.size(); ++r) {
        const ComparisonRow& row = report.scenes.front().rows[r];
        const Judgement& j = report.combined[r];
        table.add({row_name(row), formatted("%u", row.samples_a), ratio_text(j), interval_text(j),
                   p_text(j.p), p_text(j.wilcoxon_p), ratio_text(report.combined_trimmed[r]),
                   verdict_text(j)});
    }
    return formatted("All %zu scenes, geometric mean\n", report.scenes.size()) + table.text();
}

}  // namespace

std::string verdict_sentence(const ComparisonReport& report) {
    const Judgement& j = headline(report);
    const std::string at = report.by_time ? "At equal time " : "At equal samples ";
    const char* what = report.by_time ? "squared error times time" : "squared error";
    const std::string seeds = formatted("%zu seeds", j.seeds);
    switch (j.verdict) {
        case Verdict::win:
            return at +
                   formatted("A wins: B's %s is %.3f times A's (95 %%: %.3f to %.3f; ", what,
                             j.ratio, j.lo, j.hi) +
                   seeds + ").";
        case Verdict::loss:
            return at +
                   formatted("B wins: A's %s is %.3f times B's (95 %%: %.3f to %.3f; ", what,
                             1 / j.ratio, 1 / j.hi, 1 / j.lo) +
                   seeds + ").";
        case Verdict::tie:
            return at +
                   formatted("neither wins: B's %s is %.3f times A's (95 %%: %.3f to %.3f; ", what,
                             j.ratio, j.lo, j.hi) +
                   seeds + "), which is within 2 %.";
        case Verdict::undecided:
            return at +
                   formatted(
                       "it is undecided: B's %s is %.3f times A's (95 %%: %.3f to %.3f) "
                       "after ",
                       what, j.ratio, j.lo, j.hi) +
                   seeds +
                   (j.seeds_needed ? formatted("; about %.0f would decide.", *j.seeds_needed)
                                   : "; more would not decide: the same program differs as much "
                                     "from run to run.");
        case Verdict::refused:
            break;
    }
    return at + "there is no verdict: " + j.reason + ".";
}

std::string to_text(const ComparisonReport& report) {
    std::string all;
    for (const SceneComparison& scene : report.scenes) all += scene_text(scene) + "\n";
    if (!report.combined.empty()) all += combined_table(report) + "\n";
    all +=
        "Errors are root mean squares of the luminance over the picture's mean, against the\n"
        "reference, whose own variance is subtracted. B/A is the ratio of their squares, at\n"
        "equal time of their squares times the time; trimmed is the same without the worst\n"
        "0.1 % of the pixels.\n";
    if (report.scenes.size() > 1) all += "p is adjusted by Holm over the scenes.\n";
    return all + verdict_sentence(report) + "\n";
}

}  // namespace lobe
