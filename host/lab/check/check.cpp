// SPDX-License-Identifier: Apache-2.0
#include "lab/check/check.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "base/statistics.h"
#include "base/timer.h"
#include "lab/check/check_context.h"
#include "scene/measured.h"

namespace lobe {

CheckEffort CheckEffort::reduced() {
    CheckEffort effort;
    effort.sets = 2;
    effort.edges = 0;
    effort.extreme_sets = 4;
    effort.angles = {60};
    effort.directions = 4;
    effort.samples = 1024;
    effort.pilot = 64;
    effort.lookout = 8;
    effort.cells = 8;
    effort.nodes = 10000;
    effort.most_unresolved = 1;
    effort.resolution = 2e-2;
    effort.furnace_sets = 1;
    effort.furnace_pixels = 4;
    effort.furnace_samples = 8;
    effort.furnace_angles = {45};
    effort.both_ways = false;
    return effort;
}

void Finding::see(double figure, const std::string& place) {
    ++tests;
    if (figure <= worst) return;  // a NaN is worse than anything
    if (std::isnan(worst)) return;
    worst = figure;
    where = place;
}

void Finding::see_p(double probability, const std::string& place) {
    ++tests;
    p.push_back(std::isnan(probability) ? 0 : probability);
    if (p.back() > least_) return;
    least_ = p.back();
    where = place;
}

bool ModelReport::passed() const {
    return std::all_of(findings.begin(), findings.end(), [](const Finding& f) { return f.passed; });
}

double judge(std::vector<ModelReport>& reports) {
    std::size_t tests = 0;
    for (const ModelReport& report : reports)
        for (const Finding& finding : report.findings) tests += finding.p.size();
    const double level = sidak(check_alpha, std::max(1.0, static_cast<double>(tests)));
    for (ModelReport& report : reports)
        for (Finding& finding : report.findings) {
            if (!finding.p.empty() && finding.least_p() < level) finding.passed = false;
            if (!std::isnan(finding.limit) && !(finding.worst <= finding.limit))
                finding.passed = false;
        }
    return level;
}

void ClaimTest::see(bool claimed, double violation, const std::string& where) {
    if (claimed) {
        finding_.see(violation, where);
        return;
    }
    ++withheld_;
    if (violation <= shown_) return;
    shown_ = violation;
    shown_where_ = where;
}

Finding ClaimTest::finish(const std::string& claim, bool both_ways) {
    finding_.limit = limit_;
    if (withheld_ == 0) return finding_;
    const bool broken = shown_ > limit_;
    finding_.note =
        "withheld in " + std::to_string(withheld_) + " cases, " +
        (broken ? "broken by " + short_number(shown_) + " (" + shown_where_ + ")"
                : "not seen broken" + (both_ways ? ": claim to be " + claim : std::string()));
    if (finding_.tests == 0) {
        finding_.worst = shown_;
        finding_.limit = std::numeric_limits<double>::quiet_NaN();
    }
    finding_.tests += withheld_;
    finding_.passed = broken || !both_ways;
    return finding_;
}

glm::dvec3 view_at(double degrees, double azimuth) {
    const double elevation = glm::radians(90 - degrees);
    const double r = std::cos(elevation);
    return rounded({r * std::cos(azimuth), r * std::sin(azimuth), std::sin(elevation)});
}

namespace {

ParameterSet scaled_colours(const BrdfTable& model, ParameterSet set, double scale) {
    for (std::size_t i = 0; i < set.rows.size(); ++i)
        if (model.parameters[i].kind == BrdfParameterKind::color)
            for (int k = 0; k < 3; ++k)
                set.rows[i][k] = std::min(static_cast<float>(model.parameters[i].highest),
                                          static_cast<float>(scale) * set.rows[i][k]);
    return set;
}

// Sets whose colours are scaled to where the model's claim to conserve energy just holds: a bound
// that is a little too generous shows there or nowhere. None where no scale ends the claim.
std::vector<ParameterSet> edges_of_energy(BrdfProbe& probe, const std::vector<ParameterSet>& sets,
                                          const std::vector<float>& tables) {
    if (sets.empty()) return {};
    std::vector<double> holds(sets.size(), 0), fails(sets.size(), 64);
    for (int step = 0; step < 30; ++step) {
        std::vector<BrdfRows> rows;
        for (std::size_t i = 0; i < sets.size(); ++i)
            rows.push_back(
                scaled_colours(probe.model(), sets[i], 0.5 * (holds[i] + fails[i])).rows);
        probe.set_parameters(rows, tables);
        for (std::size_t i = 0; i < sets.size(); ++i)
            (probe.claims()[i].conserves_energy ? holds : fails)[i] = 0.5 * (holds[i] + fails[i]);
    }
    std::vector<ParameterSet> edges;
    for (std::size_t i = 0; i < sets.size(); ++i) {
        if (holds[i] == 0 || fails[i] == 64) continue;
        edges.push_back(scaled_colours(probe.model(), sets[i], holds[i]));
        edges.back().text += ", colours times " + short_number(holds[i]);
    }
    return edges;
}

// At most `most` sets of the sweep that leave the colours at their defaults, evenly chosen.
std::vector<ParameterSet> sets_without_colours(const BrdfTable& model, std::size_t most) {
    const BrdfRows standard = model.default_rows();
    std::vector<ParameterSet> sets = parameter_sweep(model, 10000), some;
    const auto coloured = [&](const ParameterSet& set) {
        for (std::size_t i = 0; i < standard.size(); ++i)
            if (model.parameters[i].kind == BrdfParameterKind::color && set.rows[i] != standard[i])
                return true;
        return false;
    };
    sets.erase(std::remove_if(sets.begin(), sets.end(), coloured), sets.end());
    const std::size_t count = std::min(most, sets.size());
    for (std::size_t k = 0; k < count; ++k) some.push_back(sets[k * sets.size() / count]);
    return some;
}

}  // namespace

CheckContext make_check_context(const Device& device, const KernelText& kernels,
                                const std::vector<BrdfTable>& models, const BrdfTable& model,
                                const CheckOptions& options) {
    CheckContext context{device, kernels, models,
                         model,  options, BrdfProbe(device, kernels, model)};
    if (device.info().fp64)
        context.oracle = std::make_unique<BrdfProbe>(device, kernels, model, Precision::twice);
    for (const BrdfParameter& p : model.parameters)
        if (p.kind == BrdfParameterKind::table) context.tables = made_up_table();
    context.sets = parameter_sweep(model, options.effort.sets);
    const std::vector<ParameterSet> some = sets_without_colours(model, options.effort.edges);
    for (ParameterSet& edge : edges_of_energy(context.probe, some, context.tables))
        context.sets.push_back(std::move(edge));
    std::vector<BrdfRows> rows;
    for (const ParameterSet& set : context.sets) rows.push_back(set.rows);
    context.probe.set_parameters(rows, context.tables);
    if (context.oracle) context.oracle->set_parameters(rows, context.tables);
    for (std::uint32_t set = 0; set < rows.size(); ++set)
        for (const double degrees : options.effort.angles)
            context.cases.push_back(
                {set, degrees, view_at(degrees),
                 context.sets[set].text + " at " + short_number(degrees) + " deg"});
    return context;
}

ModelReport check_model(const Device& device, const KernelText& kernels,
                        const std::vector<BrdfTable>& models, const BrdfTable& model,
                        const CheckOptions& options) {
    ModelReport report;
    report.model = model.name;
    const Stopwatch compile;
    CheckContext context = make_check_context(device, kernels, models, model, options);
    report.compile_s = compile.seconds();
    const Stopwatch watch;
    report.sets = context.sets.size();
    const auto take = [&](std::vector<Finding> findings) {
        for (Finding& finding : findings) report.findings.push_back(std::move(finding));
    };
    take(check_values(context));
    take(check_sampling(context, report));
    take(check_extremes(context));  // changes the parameter sets: last
    report.findings.push_back(check_furnace(context));
    report.check_s = watch.seconds();
    return report;
}

}  // namespace lobe
