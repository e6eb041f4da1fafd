// SPDX-License-Identifier: Apache-2.0
#include "lab/check/extremes.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <memory>

#include "base/random.h"
#include "base/statistics.h"
#include "base/timer.h"
#include "cl/device.h"

namespace lobe {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double least_cosine = 1.2e-38;  // the smallest that devices without subnormals keep

glm::dvec3 at_cosine(double z, double azimuth) {
    const double r = std::sqrt((1 - z) * (1 + z));
    return {r * std::cos(azimuth), r * std::sin(azimuth), z};
}

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x + v.y + v.z); }

// The largest difference of the channels, relative to the reference.
double relative_difference(const glm::dvec3& value, const glm::dvec3& reference) {
    double worst = 0;
    for (int k = 0; k < 3; ++k)
        worst = std::max(worst, std::abs(value[k] - reference[k]) /
                                    std::max(std::abs(reference[k]), FormErrors::least_value));
    return worst;
}

// Values of many sets for the same pairs: item i belongs to set i / pairs.
using Values = std::vector<glm::dvec3>;

Values values_of(const BrdfProbe& probe, const BrdfQuery& query) {
    Values values;
    for (const BrdfValue& value : probe.eval(query)) values.push_back(value.f);
    return values;
}

template <typename Change>
BrdfQuery make_query(std::size_t sets, const std::vector<StiffPair>& pairs, Change change) {
    BrdfQuery query;
    for (std::uint32_t set = 0; set < sets; ++set)
        for (const StiffPair& pair : pairs) query.add(set, change(pair.wo), change(pair.wi));
    return query;
}

FormErrors errors_of(const Values& values, const Values& exact, std::size_t first,
                     std::size_t count) {
    FormErrors errors;
    std::vector<double> relative;
    for (std::size_t i = first; i < first + count; ++i) {
        const glm::dvec3& v = values[i];
        errors.negative += v.x < 0 || v.y < 0 || v.z < 0;
        if (!is_finite(v))
            ++errors.nonfinite;
        else if (!exact.empty())
            relative.push_back(relative_difference(v, exact[i]));
    }
    errors.median = median(relative);
    errors.worst = relative.empty() ? unknown : *std::max_element(relative.begin(), relative.end());
    return errors;
}

// How far values move as the directions are rounded, and as they move by up to half an ulp.
std::vector<double> conditioning(const BrdfProbe& oracle, std::size_t sets,
                                 const std::vector<StiffPair>& pairs, const Values& exact,
                                 const Values& rounded) {
    std::vector<double> largest(exact.size());
    const auto see = [&](const Values& moved) {
        for (std::size_t i = 0; i < exact.size(); ++i)
            largest[i] = std::max(largest[i], relative_difference(moved[i], exact[i]));
    };
    see(rounded);
    Random random(71);
    for (int time = 0; time < 4; ++time)
        see(values_of(oracle, make_query(sets, pairs, [&](glm::dvec3 v) {
                          for (int k = 0; k < 3; ++k)
                              if (v[k] != 0)
                                  v[k] +=
                                      std::ldexp(random.uniform(-0.5, 0.5), std::ilogb(v[k]) - 23);
                          return v;
                      })));
    return largest;
}

// The subject as it is, and each of its colours in turn black, with what that is called.
std::vector<std::pair<std::string, BrdfRows>> colour_sets(const Subject& subject) {
    std::vector<std::pair<std::string, BrdfRows>> sets = {{"", subject.rows}};
    const std::vector<BrdfParameter>& parameters = subject.model.parameters;
    const auto colours = std::count_if(parameters.begin(), parameters.end(), [](const auto& p) {
        return p.kind == BrdfParameterKind::color;
    });
    for (std::size_t i = 0; i < parameters.size() && colours > 1; ++i) {
        const BrdfParameter& p = parameters[i];
        if (p.kind != BrdfParameterKind::color || p.standard == 0 || p.lowest > 0) continue;
        sets.emplace_back(p.name + " 0", subject.rows);
        sets.back().second[i] = {0, 0, 0, 0};
    }
    return sets;
}

}  // namespace

std::vector<double> stiff_values(const BrdfParameter& p) {
    std::vector<double> values = {p.standard, p.lowest, 0, 1 - 0x1p-24, 1, 1 + 0x1p-23};
    if (std::isinf(p.highest)) {
        for (const double v : {1e-30, 1e-6, .05, .5, 2., 3e38, double(INFINITY)})
            values.push_back(v);
        for (double v = 10; v < 2e12; v *= 10) values.push_back(v);
    } else {
        const double width = p.highest - p.lowest;
        for (const double part : {1e-30, 1e-12, 1e-6, 1e-4, 1e-3, 1e-2, .1, .5}) {
            values.push_back(p.lowest + part * width);
            values.push_back(p.highest - part * width);
        }
        values.push_back(p.highest);
    }
    for (double& v : values) v = static_cast<float>(v);
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    const auto outside = [&](double v) { return !(v >= p.lowest && v <= p.highest); };
    values.erase(std::remove_if(values.begin(), values.end(), outside), values.end());
    return values;
}

std::vector<StiffPair> near_mirror_pairs(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<StiffPair> pairs;
    while (pairs.size() < count) {
        const glm::dvec3 wo =
            at_cosine(random.uniform(1e-3, 1), random.uniform(0, glm::two_pi<double>()));
        const glm::dvec3 mirror(-wo.x, -wo.y, wo.z);
        const double apart = random.log_uniform(1e-8, glm::half_pi<double>());
        const glm::dvec3 any(random.normal(), random.normal(), random.normal());
        const glm::dvec3 aside = glm::normalize(any - glm::dot(any, mirror) * mirror);
        const glm::dvec3 wi = std::cos(apart) * mirror + std::sin(apart) * aside;
        if (wi.z > 1e-3) pairs.push_back({wo, wi});
    }
    return pairs;
}

std::vector<StiffPair> grazing_pairs(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<StiffPair> pairs;
    for (std::size_t i = 0; i < count; ++i) {
        const auto cosine = [&](bool grazing) {
            return grazing ? random.log_uniform(least_cosine, 1) : random.uniform(1e-3, 1);
        };
        const std::size_t which = i % 3;  // wi, wo, or both: then half of them almost forward
        const double azimuth = random.uniform(0, glm::two_pi<double>());
        const double turn = which == 2 && i % 2 ? random.log_uniform(1e-8, 1)
                                                : random.uniform(0, glm::pi<double>());
        pairs.push_back({at_cosine(cosine(which != 0), azimuth),
                         at_cosine(cosine(which != 1), azimuth + glm::pi<double>() + turn)});
    }
    return pairs;
}

std::vector<ExtremesRow> measure_extremes(const ExtremesProbes& probes,
                                          const std::vector<BrdfRows>& sets,
                                          const std::vector<StiffPair>& pairs) {
    probes.single.set_parameters(sets, probes.tables);
    const BrdfQuery held = make_query(sets.size(), pairs, lobe::rounded);
    const Values ours = values_of(probes.single, held);
    const bool has_formula = probes.single.model().has_formula;
    Values naive = has_formula ? probes.single.formula(held) : Values();
    for (std::size_t i = 0; i < naive.size(); ++i) naive[i] *= held.second[i].z;
    Values exact, rounded;
    std::vector<double> limits;
    if (probes.oracle) {
        probes.oracle->set_parameters(sets, probes.tables);
        exact = values_of(*probes.oracle,
                          make_query(sets.size(), pairs, [](const glm::dvec3& v) { return v; }));
        rounded = values_of(*probes.oracle, held);
        limits = conditioning(*probes.oracle, sets.size(), pairs, exact, rounded);
    }
    std::vector<ExtremesRow> rows(sets.size());
    for (std::size_t set = 0; set < sets.size(); ++set) {
        ExtremesRow& row = rows[set];
        const std::size_t first = set * pairs.size(), end = first + pairs.size();
        row.ours = errors_of(ours, exact, first, pairs.size());
        if (has_formula) row.naive = errors_of(naive, exact, first, pairs.size());
        if (!probes.oracle) row.limit = row.arithmetic = unknown;
        for (std::size_t i = first; i < end && probes.oracle; ++i) {
            row.limit = std::max(row.limit, limits[i]);
            if (!is_finite(exact[i])) row.excess = INFINITY;  // no reference is no pass
            if (!is_finite(ours[i])) continue;
            row.arithmetic = std::max(row.arithmetic, relative_difference(ours[i], rounded[i]));
            row.excess =
                std::max(row.excess, relative_difference(ours[i], exact[i]) /
                                         (allowed_conditionings * limits[i] + allowed_rounding));
        }
    }
    return rows;
}

bool ExtremesBlock::passed() const {
    return std::all_of(rows.begin(), rows.end(), [](const ExtremesRow& r) { return r.passed(); });
}

double ExtremesBlock::limit() const {
    double largest = 0;
    for (const ExtremesRow& row : rows) largest = std::max(largest, row.limit);
    return largest;
}

bool ExtremesReport::passed() const {
    return std::all_of(blocks.begin(), blocks.end(), [](const auto& b) { return b.passed(); });
}

std::vector<const ExtremesBlock*> ExtremesReport::telling() const {
    std::vector<const ExtremesBlock*> shown;
    for (const ExtremesBlock& block : blocks) {
        const bool most = std::all_of(blocks.begin(), blocks.end(), [&](const ExtremesBlock& b) {
            return b.parameter != block.parameter || b.directions != block.directions ||
                   b.limit() < block.limit() || (b.limit() == block.limit() && &b >= &block);
        });
        if (most || !block.passed()) shown.push_back(&block);
    }
    return shown;
}

ExtremesReport report_extremes(const Device& device, const KernelText& kernels,
                               const Subject& subject, std::size_t pairs) {
    ExtremesReport report;
    report.model = subject.model.name;
    report.pairs = pairs;
    report.has_formula = subject.model.has_formula;
    report.has_reference = device.info().fp64;
    const Stopwatch compile;
    BrdfProbe single(device, kernels, subject.model);
    std::unique_ptr<BrdfProbe> oracle;
    if (report.has_reference)
        oracle = std::make_unique<BrdfProbe>(device, kernels, subject.model, Precision::twice);
    report.compile_s = compile.seconds();
    const Stopwatch watch;
    const ExtremesProbes probes{single, oracle.get(), subject.tables};
    const std::pair<const char*, std::vector<StiffPair>> kinds[] = {
        {"near the mirror direction", near_mirror_pairs(pairs, 61)},
        {"at grazing angles", grazing_pairs(pairs, 62)}};
    const auto add = [&](const std::string& parameter, const std::vector<double>& values,
                         std::size_t place) {
        for (const auto& [directions, of] : kinds)
            for (const auto& [changed, base] : colour_sets(subject)) {
                std::vector<BrdfRows> sets(std::max<std::size_t>(values.size(), 1), base);
                for (std::size_t i = 0; i < values.size(); ++i)
                    sets[i][place] = {static_cast<float>(values[i]), 0, 0, 0};
                ExtremesBlock block{parameter, directions, changed,
                                    measure_extremes(probes, sets, of)};
                for (std::size_t i = 0; i < values.size(); ++i) block.rows[i].value = values[i];
                report.blocks.push_back(std::move(block));
            }
    };
    const std::vector<BrdfParameter>& parameters = subject.model.parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i)
        if (parameters[i].kind == BrdfParameterKind::number)
            add(parameters[i].name, stiff_values(parameters[i]), i);
    if (report.blocks.empty()) add("", {}, 0);
    report.measure_s = watch.seconds();
    return report;
}

}  // namespace lobe
