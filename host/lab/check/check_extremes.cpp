// SPDX-License-Identifier: Apache-2.0
// Whatever is asked, the answer is a number and not negative: at the ends of all parameters, at
// grazing angles, at the ends of the random numbers. And rubbish in does not hang or turn negative.
#include <algorithm>
#include <cmath>

#include "lab/check/check_context.h"

namespace lobe {
namespace {

bool sound(double v) { return std::isfinite(v) && v >= 0; }
bool sound(const glm::dvec3& v) { return sound(v.x) && sound(v.y) && sound(v.z); }
bool negative(const glm::dvec3& v) { return v.x < 0 || v.y < 0 || v.z < 0; }

std::vector<glm::dvec3> views() {
    return {{0, 0, 1},
            rounded({1e-20, 0, 1}),
            view_at(45),
            view_at(89.99),
            rounded({std::cos(0.7), std::sin(0.7), 1e-30})};
}

std::vector<glm::dvec3> lights(const glm::dvec3& wo) {
    const glm::dvec3 mirror(-wo.x, -wo.y, wo.z);
    std::vector<glm::dvec3> all = {mirror, wo, {0, 0, 1}, view_at(30, 2), view_at(89.9999, -1)};
    for (const double off : {1e-7, 1e-5, 1e-3, 0.03})
        all.push_back(rounded(glm::normalize(mirror + off * glm::dvec3(0.6, -0.3, 0.5))));
    for (const double z : {1e-3, 1e-10, 1e-20, 1.2e-38})
        all.push_back(rounded({-std::cos(0.7), -std::sin(0.7), z}));
    return all;
}

std::vector<glm::dvec3> numbers() {
    std::vector<glm::dvec3> all;
    const double ends[] = {0, 0x1p-24, 0.5, 1 - 0x1p-24};
    for (const double a : ends)
        for (const double b : ends)
            for (const double c : ends) all.push_back({a, b, c});
    return all;
}

void check_finite(CheckContext& context, const std::vector<ParameterSet>& sets, Finding& finding) {
    BrdfQuery values, samples;
    for (std::uint32_t set = 0; set < sets.size(); ++set)
        for (const glm::dvec3& wo : views()) {
            for (const glm::dvec3& wi : lights(wo))
                if (wi.z > 0) values.add(set, wo, wi);
            for (const glm::dvec3& u : numbers()) samples.add(set, wo, u);
        }
    const std::vector<BrdfValue> found = context.probe.eval(values);
    for (std::size_t i = 0; i < found.size(); ++i)
        finding.see(!(sound(found[i].f) && sound(found[i].pdf)),
                    sets[values.sets[i]].text + ", wo.z " + short_number(values.wo[i].z) +
                        ", wi.z " + short_number(values.second[i].z));
    const std::vector<BrdfSampled> drawn = context.probe.sample(samples);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const BrdfSampled& s = drawn[i];
        const bool good =
            sound(s.pdf) && sound(s.weight) && std::isfinite(s.wi.x + s.wi.y + s.wi.z);
        const bool black = s.weight == glm::dvec3(0);
        finding.see(!good || (!black && !(s.wi.z > 0)),
                    "a sample at " + sets[samples.sets[i]].text + ", wo.z " +
                        short_number(samples.wo[i].z) + ", u " + short_number(samples.second[i].x) +
                        " " + short_number(samples.second[i].y) + " " +
                        short_number(samples.second[i].z));
    }
}

void check_garbage(CheckContext& context, std::size_t sets, Finding& finding) {
    std::vector<glm::dvec3> rubbish;
    for (const double v : {double(NAN), double(INFINITY), 0.0, 1e-40, 1e30, -1.0})
        for (const double w : {v, 0.5}) rubbish.push_back({w, v, v});
    BrdfQuery values, samples;
    for (std::uint32_t set = 0; set < sets; ++set)
        for (const glm::dvec3& bad : rubbish) {
            values.add(set, bad, view_at(30));
            values.add(set, view_at(30), bad);
            values.add(set, bad, bad);
            samples.add(set, bad, {0.3, 0.6, 0.4});
        }
    const auto place = [](const BrdfQuery& query, std::size_t i) {
        return "set " + std::to_string(query.sets[i]) + ", wo.y " + short_number(query.wo[i].y) +
               ", wi.y " + short_number(query.second[i].y);
    };
    const std::vector<BrdfValue> found = context.probe.eval(values);
    for (std::size_t i = 0; i < found.size(); ++i) {
        // A light below the horizon is never asked for.
        const bool asked = values.second[i].z > 0 && values.wo[i].z > 0;
        finding.see(asked && (negative(found[i].f) || found[i].pdf < 0), place(values, i));
    }
    const std::vector<BrdfSampled> drawn = context.probe.sample(samples);
    for (std::size_t i = 0; i < drawn.size(); ++i)
        finding.see(samples.wo[i].z > 0 && (negative(drawn[i].weight) || drawn[i].pdf < 0),
                    place(samples, i));
}

}  // namespace

std::vector<Finding> check_extremes(CheckContext& context) {
    std::vector<ParameterSet> sets = extreme_parameters(context.model);
    const std::size_t most = context.options.effort.extreme_sets;
    for (std::size_t i = 0; i < most && sets.size() > most; ++i)
        sets[i] = sets[i * sets.size() / most];
    if (sets.size() > most) sets.resize(most);
    std::vector<BrdfRows> rows;
    for (const ParameterSet& set : sets) rows.push_back(set.rows);
    context.probe.set_parameters(rows, context.tables);
    Finding finite("finite"), garbage("garbage");
    finite.limit = garbage.limit = 0;
    check_finite(context, sets, finite);
    check_garbage(context, std::min<std::size_t>(sets.size(), 16), garbage);
    garbage.note = "rubbish gives no negative light and returns";
    return {finite, garbage};
}

}  // namespace lobe
