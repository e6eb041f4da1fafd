// SPDX-License-Identifier: Apache-2.0
#include "lab/parameter_sweep.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "base/random.h"

namespace lobe {
namespace {

using Values = std::vector<double>;

void keep_within(Values& values, const BrdfParameter& p) {
    const auto lowest = static_cast<float>(p.lowest), highest = static_cast<float>(p.highest);
    for (double& v : values) v = static_cast<float>(v);
    values.erase(std::remove_if(values.begin(), values.end(),
                                [&](double v) { return !(v >= lowest && v <= highest); }),
                 values.end());
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

// Values of one parameter that a check should see; the default is always there.
Values sweep_of(const BrdfParameter& p) {
    Values values = {p.standard, p.lowest};
    switch (p.kind) {
        case BrdfParameterKind::choice:
            for (std::size_t i = 0; i < p.choices.size(); ++i)
                values.push_back(static_cast<double>(i));
            break;
        case BrdfParameterKind::integer:
            for (double v = p.lowest; v <= std::min(p.highest, p.lowest + 16); v += 1)
                values.push_back(v);
            if (std::isfinite(p.highest)) values.push_back(p.highest);
            break;
        case BrdfParameterKind::color:
            for (const double v : {0.0, 0.1, 0.5, 1.0}) values.push_back(v);
            if (std::isfinite(p.highest)) values.push_back(p.highest);
            break;
        case BrdfParameterKind::number:
            if (std::isfinite(p.highest)) {
                for (double part = 1; part > 1e-3; part *= 0.3)
                    values.push_back(p.lowest + part * (p.highest - p.lowest));
            } else {
                for (const double v : {0.0, 0.02, 0.5, 1.0, 2.0, 10.0, 100.0, 1e4, 1e6})
                    values.push_back(v);
            }
            break;
        case BrdfParameterKind::table:
            values = {0};
    }
    keep_within(values, p);
    return values;
}

class Sweep {
  public:
    explicit Sweep(const BrdfTable& model) : model_(model) {
        for (const BrdfParameter& p : model.parameters) {
            values_.push_back(sweep_of(p));
            standard_.push_back(p.standard);
        }
    }

    const Values& standard() const { return standard_; }
    const std::vector<Values>& values() const { return values_; }

    void add(const Values& set) {
        if (seen_.insert(set).second) sets_.push_back(set);
    }

    // Every combination of the choices, the other parameters at their defaults.
    std::vector<Values> choices() const {
        std::vector<Values> all = {standard_};
        for (std::size_t i = 0; i < values_.size(); ++i) {
            if (model_.parameters[i].kind != BrdfParameterKind::choice) continue;
            const std::vector<Values> before = all;
            for (const double v : values_[i])
                for (Values set : before) {
                    set[i] = v;
                    if (v != standard_[i]) all.push_back(set);
                }
        }
        return all;
    }

    // Each parameter in turn, the others as they are in `base`.
    void one_at_a_time(const Values& base) {
        add(base);
        for (std::size_t i = 0; i < values_.size(); ++i) {
            if (model_.parameters[i].kind == BrdfParameterKind::choice) continue;
            for (const double v : values_[i]) {
                Values set = base;
                set[i] = v;
                add(set);
            }
        }
    }

    void corners(std::size_t count) {
        Random random(1);
        for (std::size_t k = 0; k < count; ++k) {
            Values set = standard_;
            for (std::size_t i = 0; i < set.size(); ++i)
                set[i] = values_[i][random.below(2) ? values_[i].size() - 1 : 0];
            add(set);
        }
    }

    std::vector<ParameterSet> finish(std::size_t most) const {
        std::vector<ParameterSet> out;
        const std::size_t count = std::min(most, sets_.size());
        for (std::size_t k = 0; k < count; ++k)
            out.push_back(describe(sets_[k * sets_.size() / count]));
        return out;
    }

  private:
    ParameterSet describe(const Values& set) const {
        ParameterSet out{model_.default_rows(), ""};
        for (std::size_t i = 0; i < set.size(); ++i) {
            const BrdfParameter& p = model_.parameters[i];
            if (p.kind == BrdfParameterKind::table || set[i] == standard_[i]) continue;
            const bool colour = p.kind == BrdfParameterKind::color;
            const auto v = static_cast<float>(set[i]);
            out.rows[i] = {v, colour ? v : 0, colour ? v : 0, 0};
            out.text +=
                (out.text.empty() ? "" : ", ") + p.name + " " +
                (p.kind == BrdfParameterKind::choice ? p.choices[static_cast<std::size_t>(set[i])]
                                                     : short_number(set[i]));
        }
        if (out.text.empty()) out.text = "defaults";
        return out;
    }

    const BrdfTable& model_;
    std::vector<Values> values_;
    Values standard_;
    std::vector<Values> sets_;
    std::set<Values> seen_;
};

}  // namespace

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

std::vector<ParameterSet> parameter_sweep(const BrdfTable& model, std::size_t most) {
    Sweep sweep(model);
    const std::vector<Values> choices = sweep.choices();
    for (const Values& base : choices) sweep.one_at_a_time(base);
    sweep.corners(8);
    return sweep.finish(most);
}

std::vector<ParameterSet> extreme_parameters(const BrdfTable& model) {
    Sweep sweep(model);
    for (const Values& base : sweep.choices()) {
        for (std::size_t i = 0; i < base.size(); ++i) {
            const BrdfParameter& p = model.parameters[i];
            if (p.kind != BrdfParameterKind::number && p.kind != BrdfParameterKind::color) continue;
            Values values = {p.lowest, p.highest,  0,   1e-38, 1e-30, 1e-6, 1 - 6e-8, 1e-3,
                             1.0,      1 + 1.2e-7, 1e8, 1e12,  1e30,  3e38, HUGE_VAL};
            // A colour beyond 1e30 overflows by right.
            if (p.kind == BrdfParameterKind::color) values = {p.lowest, 0, 1e-38, 1e-3, 1, 1e12};
            keep_within(values, p);
            for (const double v : values) {
                Values set = base;
                set[i] = v;
                sweep.add(set);
            }
        }
    }
    sweep.corners(8);
    return sweep.finish(400);
}

}  // namespace lobe
