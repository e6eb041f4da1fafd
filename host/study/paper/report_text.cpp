// SPDX-License-Identifier: Apache-2.0
// `lobe paper` in words and tables.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/format.h"
#include "report/text_table.h"
#include "study/paper/report.h"

namespace lobe {
namespace {

const PaperRow paper;

std::string ratio_text(const RatioInterval& r) {
    return std::isfinite(r.lo) ? formatted("%.3f (%.3f to %.3f)", r.ratio, r.lo, r.hi)
                               : formatted("%.3f", r.ratio);
}

std::string percent(double part) {
    return std::isfinite(part) ? formatted("%.2f", 100 * part) : "-";
}

std::string display_name(const std::string& model) {
    if (model == "phong") return "Phong";
    return model == "modified_phong" ? "modified Phong" : model;
}

std::string alike(const ModelSetting& setting) {
    if (setting.listing) return "as the listing";
    if (setting.model == "rational") return "base";
    return to_text(setting.footing);
}

std::string range(double a, double b) {
    if (a > b) std::swap(a, b);
    return formatted("%.1f", a) == formatted("%.1f", b) ? formatted("%.1f", a)
                                                        : formatted("%.1f to %.1f", a, b);
}

// Of the claim of lower error.
std::string said(const FootingFindings& found) {
    switch (found.holds()) {
        case Holds::yes:
            return "it holds";
        case Holds::no:
            return "it does not hold";
        default:
            return "undecided";
    }
}

std::string ratios_at(const PaperFindings& findings, Footing footing, std::size_t sampler) {
    for (const FootingFindings& f : findings.footings)
        if (f.footing == footing && f.sampler == sampler)
            return formatted("%.3f of Phong's and %.3f of modified Phong's",
                             f.against[0].rmse.ratio, f.against[1].rmse.ratio) +
                   ": " + said(f);
    return "";
}

std::string colour_text(const glm::dvec3& c) {
    return c.x == c.y && c.y == c.z ? formatted("%.4g", c.x)
                                    : formatted("%.4g %.4g %.4g", c.x, c.y, c.z);
}

std::string table_text(const Rows& rows) {
    TextTable table(rows.front());
    for (std::size_t i = 1; i < rows.size(); ++i) table.add(rows[i]);
    return table.text();
}

}  // namespace

std::string errors_legend() {
    return "error: root mean square of the luminance's error over the mean luminance, each model "
           "against\nits own reference, whose variance is subtracted (95 %: over the runs); "
           "trimmed: without the\n0.1 % worst pixels of each run; 255 |e|: 255 times the mean "
           "absolute error of R, G, B; s: median\nseconds of a run. The paper does not say what "
           "its error is.\n"
           "as the listing (a footnote): cos phi as the paper's program text computes it, which "
           "is another\npicture, without a highlight: its error is no answer to the others'.\n";
}

std::string footings_legend() {
    return "equal parameters: the same kd, ks (1/sr) and n; equal albedo: the same kd and n, ks "
           "such that the\nlobe's directional albedo at normal incidence is the rational one's; "
           "equal half-width: the same kd\nand ks, which is the lobe's height, n such that the "
           "lobe falls to half as far from its peak.\n";
}

Rows error_rows(const PaperReport& report) {
    Rows rows = {{"model", "alike in", "sampler", "s", "error %", "95 %", "trimmed %", "255 |e|"}};
    for (const auto& [i, model] : {std::pair(0, "rational"), {1, "Phong"}, {2, "modified Phong"}})
        rows.push_back({model, "not said", "the paper's row", formatted("%.1f", paper.seconds[i]),
                        formatted("%.4f", paper.error[i]), "-", "-", "-"});
    const PaperExperiment& experiment = report.experiment;
    for (std::size_t k = 0; k < paper_samplers.size(); ++k)
        for (std::size_t s = 0; s < experiment.settings.size(); ++s) {
            const ModelSetting& setting = experiment.settings[s].setting;
            const CellFindings& cell = report.findings.cells[s][k];
            rows.push_back({display_name(setting.model), alike(setting), paper_samplers[k].name,
                            formatted("%.3f", cell.seconds), percent(cell.rmse),
                            percent(cell.rmse_lo) + " to " + percent(cell.rmse_hi),
                            percent(cell.trimmed), formatted("%.3f", cell.absolute)});
        }
    return rows;
}

Rows ratio_rows(const PaperReport& report) {
    Rows rows = {{"alike in", "sampler", "error / Phong", "error / modified", "255 |e| ratios",
                  "time ratios", "verdicts"}};
    rows.push_back({"not said", "the paper's row", formatted("%.4f", paper.to_phong),
                    formatted("%.4f", paper.to_modified), "-",
                    formatted("%.3f, %.3f", paper.seconds[0] / paper.seconds[1],
                              paper.seconds[0] / paper.seconds[2]),
                    "-"});
    for (const FootingFindings& f : report.findings.footings) {
        const auto& [phong, modified] = f.against;
        rows.push_back(
            {to_text(f.footing), paper_samplers[f.sampler].name, ratio_text(phong.rmse),
             ratio_text(modified.rmse),
             formatted("%.3f, %.3f", phong.absolute.ratio, modified.absolute.ratio),
             formatted("%.3f, %.3f", phong.time.ratio, modified.time.ratio),
             to_text(phong.judgement.verdict) + ", " + to_text(modified.judgement.verdict)});
    }
    return rows;
}

Rows parameter_rows(const PaperReport& report) {
    Rows rows = {{"material", "model", "alike in", "kd", "ks", "n"}};
    const PaperExperiment& e = report.experiment;
    for (std::size_t w = 0; w < e.wearers.size(); ++w)
        for (const PaperSetting& s : e.settings) {
            const LobeParameters& p = s.setting.parameters[w];
            rows.push_back({e.wearers[w].type + formatted(" %zu", w + 1),
                            display_name(s.setting.model), alike(s.setting), colour_text(p.kd),
                            colour_text(p.ks), formatted("%.5g", p.n)});
        }
    return rows;
}

Rows claim_rows(const PaperReport& report) {
    Rows rows = {{"the paper's claim", "verdict", "what decides"}};
    for (const Claim& claim : report.claims)
        rows.push_back(
            {claim.statement,
             to_text(claim.holds) + (claim.condition.empty() ? "" : " " + claim.condition),
             claim.figures});
    return rows;
}

std::string conditions_text(const PaperReport& report) {
    const PaperExperiment& e = report.experiment;
    std::string types;
    for (const Wearer& wearer : e.wearers) types += (types.empty() ? "" : ", ") + wearer.type;
    std::string all =
        report.scene + formatted(": %ux%u, %u samples a pixel, %zu of %u runs", e.width, e.height,
                                 report.plan.samples, e.rounds, report.plan.runs);
    all += formatted(
        " with seeds of their own, in turn\nreferences: %u samples a pixel, one a model and "
        "parameters, shared by the samplers\n",
        report.plan.reference_samples);
    all += formatted(
        "masked: %zu pixels in which a reference sees a light directly, and their neighbours\n",
        e.masked);
    if (e.stray)
        all += formatted("warning: %zu times a run saw a light in a pixel that is not masked\n",
                         e.stray);
    all += "materials that wear the models: " + types + "\n";
    all += report.device.name + ", " + report.device.driver + "\n";
    if (report.quick)
        all += "--quick: a smaller film, fewer runs and shorter references than the paper's\n";
    return all;
}

std::string verdict_sentence(const PaperReport& report) {
    const PaperExperiment& e = report.experiment;
    if (e.rounds < 2) return "Verdict: none, for fewer than two runs of everything are complete.";
    const PaperFindings& f = report.findings;
    std::string all =
        "Verdict: with the sampling that the paper probably had, the rational "
        "model's error is";
    for (const Footing footing : footings)
        all += std::string(footing == Footing::parameters ? " at " : "; at ") + to_text(footing) +
               " " + ratios_at(f, footing, cosine_sampler);
    all += formatted(" (the paper: %.3f and %.3f). ", paper.to_phong, paper.to_modified);
    std::size_t held = 0, failed = 0;
    for (const FootingFindings& found : f.footings) {
        held += found.holds() == Holds::yes;
        failed += found.holds() == Holds::no;
    }
    all += formatted("Over the three samplers it holds in %zu and fails in %zu of %zu cases. ",
                     held, failed, f.footings.size());
    double least = INFINITY, most = 0;
    for (std::size_t s = 1; s < listing_setting; ++s) {
        least = std::min(least, f.cut[s].ratio);
        most = std::max(most, f.cut[s].ratio);
    }
    all += "At equal time " + std::string(paper_samplers[best_sampler].name) +
           " sampling cuts the noise to 1/" + formatted("%.2f", f.cut[0].ratio) +
           formatted(" (95 %%: 1/%.2f to 1/%.2f) with the rational model and to 1/", f.cut[0].lo,
                     f.cut[0].hi) +
           range(least, most) + " with the others.";
    return all;
}

std::string to_text(const PaperReport& report) {
    std::string all;
    if (report.experiment.rounds > 0) {
        all += conditions_text(report) + "\n" + table_text(parameter_rows(report)) +
               footings_legend() + "\n" + table_text(error_rows(report)) + errors_legend() + "\n" +
               "The rational model's error over the others', paired over seeds (95 %):\n" +
               table_text(ratio_rows(report)) + "\n";
    }
    for (const Claim& claim : report.claims)
        all += "claim: " + claim.statement + "\n  " + to_text(claim.holds) +
               (claim.condition.empty() ? "" : " " + claim.condition) + "\n  " + claim.figures +
               "\n";
    return all + "\n" + verdict_sentence(report) + "\n";
}

}  // namespace lobe
