// SPDX-License-Identifier: Apache-2.0
// The claims about the model itself: each a few measured numbers, then a rule.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/gtc/constants.hpp>

#include "base/format.h"
#include "study/paper/claims.h"

namespace lobe {
namespace {

constexpr double negligible = 1e-3;  // relative; less of a difference is none
const double no_less = 1e-30;        // below, a lobe has fallen to nothing
const std::vector<double> angles = {5, 10, 20, 30, 45, 60, 75, 85};  // degrees off the mirror

// Seen from the normal, where the mirror direction is the normal.
DirectionsPair off_mirror(double radians) {
    return {{0, 0, 1}, {std::sin(radians), 0, std::cos(radians)}};
}

std::vector<double> curve(const LobeValues& values, const LobeVariant& lobe) {
    std::vector<DirectionsPair> pairs;
    for (const double angle : angles) pairs.push_back(off_mirror(glm::radians(angle)));
    return values(lobe, pairs);
}

// All pairs of some views with light from all over the hemisphere.
std::vector<DirectionsPair> all_over() {
    std::vector<DirectionsPair> pairs;
    for (const double view : {0., 30., 45., 60., 85.})
        for (double light = 2.5; light < 90; light += 5)
            for (double azimuth = 0; azimuth < 360; azimuth += 30) {
                const double v = glm::radians(view), l = glm::radians(light),
                             a = glm::radians(azimuth);
                pairs.push_back(
                    {{std::sin(v), 0, std::cos(v)},
                     {std::sin(l) * std::cos(a), std::sin(l) * std::sin(a), std::cos(l)}});
            }
    return pairs;
}

// How many times as bright as the other model's the rational lobe is at each angle off the mirror
// direction; both have the same peak.
std::vector<double> excess(const LobeValues& values, const std::string& other, double n) {
    const std::vector<double> rational = curve(values, {"rational", n});
    std::vector<double> ratios = curve(values, {other, n});
    for (std::size_t i = 0; i < ratios.size(); ++i)
        ratios[i] = std::max(rational[i], no_less) / std::max(ratios[i], no_less);
    return ratios;
}

Claim slower(const LobeValues& values, const std::string& other, const std::string& key,
             const std::string& statement) {
    const std::vector<double> tried = {0.1, 0.5, 1, 2, 10, 100, 1000};
    std::vector<double> where;
    double least = INFINITY, least_n = 0;
    for (const double n : tried) {
        const std::vector<double> ratios = excess(values, other, n);
        const double low = *std::min_element(ratios.begin(), ratios.end());
        const double high = *std::max_element(ratios.begin(), ratios.end());
        if (low < least) least = low, least_n = n;
        if (low > 1 - negligible && high > 1 + negligible) where.push_back(n);
    }
    Claim claim{key, statement};
    const bool upper = !where.empty() && std::equal(where.rbegin(), where.rend(), tried.rbegin());
    if (where.size() == tried.size()) {
        claim.holds = Holds::yes;
    } else if (where.empty()) {
        claim.holds = Holds::no;
    } else {
        claim.holds = Holds::only_if;
        for (const double n : where)
            claim.condition += formatted(claim.condition.empty() ? "n = %g" : ", %g", n);
        if (upper) claim.condition = formatted("n >= %g", where.front());
        claim.condition += " (tried: 0.1 to 1000)";
    }
    claim.figures =
        formatted("n = 100, 20 deg off: %.3g times as bright; least of all: %.3g times, n = %g",
                  excess(values, other, 100)[2], least, least_n);
    return claim;
}

// The most that the lobe grows at some angle when n does; at most one where light only falls.
struct Growth {
    double most = 0, angle = 0, from = 0, to = 0;
    std::string text_of() const {
        return formatted("%.3g at %g deg, n = %g to %g", most, angle, from, to);
    }
};
Growth growth(const LobeValues& values, bool normalize) {
    const std::vector<double> ns = {0.5, 1, 2, 5, 10, 100, 1e3, 1e4, 1e6};
    Growth found;
    std::vector<double> last = curve(values, {"rational", ns[0], 0, normalize});
    for (std::size_t k = 1; k < ns.size(); ++k) {
        const std::vector<double> next = curve(values, {"rational", ns[k], 0, normalize});
        for (std::size_t i = 0; i < next.size(); ++i) {
            const double ratio = next[i] / std::max(last[i], no_less);
            if (ratio > found.most) found = {ratio, angles[i], ns[k - 1], ns[k]};
        }
        last = next;
    }
    return found;
}

Claim larger_n(const LobeValues& values) {
    const Growth raw = growth(values, false), equal = growth(values, true);
    Claim claim{"larger_n_less_light", "a larger n gives less light off the mirror direction"};
    const bool raw_holds = raw.most <= 1 + negligible, equal_holds = equal.most <= 1 + negligible;
    claim.holds = raw_holds ? equal_holds ? Holds::yes : Holds::only_if : Holds::no;
    if (claim.holds == Holds::only_if) claim.condition = "at equal ks, not at equal albedo";
    claim.figures = "most a step of n brightens: times " + raw.text_of() +
                    "; at equal albedo times " + equal.text_of();
    return claim;
}

// Least over largest value: one of a diffuse surface.
double evenness(const std::vector<double>& values) {
    const auto [least, largest] = std::minmax_element(values.begin(), values.end());
    return *least / *largest;
}

Claim diffuse(const LobeValues& values) {
    const std::vector<DirectionsPair> pairs = all_over();
    const double clamped = evenness(values({"rational", 0, 0}, pairs));
    const double absolute = evenness(values({"rational", 0, 1}, pairs));
    Claim claim{"n_0_diffuse", "n = 0 is a perfect diffuser"};
    const bool holds_clamped = clamped > 1 - negligible, holds_abs = absolute > 1 - negligible;
    claim.holds = holds_clamped ? Holds::yes : holds_abs ? Holds::only_if : Holds::no;
    if (claim.holds == Holds::only_if)
        claim.condition = "cos phi is read as |cos phi| (lobe = abs)";
    claim.figures =
        formatted("least over largest value at n = 0: clamp %.4g, abs %.4g", clamped, absolute);
    return claim;
}

// Integral of f cos over the cone of so many radians about the normal, seen from there: Simpson's
// rule in the logarithm of the angle.
double energy_within(const LobeValues& values, const LobeVariant& lobe, double radians) {
    const int steps = 4000;
    const double low = std::log(1e-9), step = (std::log(radians) - low) / steps;
    std::vector<DirectionsPair> pairs;
    for (int k = 0; k <= steps; ++k) pairs.push_back(off_mirror(std::exp(low + k * step)));
    const std::vector<double> f = values(lobe, pairs);
    double sum = 0;
    for (int k = 0; k <= steps; ++k) {
        const double angle = std::exp(low + k * step);
        const double weight = k == 0 || k == steps ? 1 : k % 2 ? 4 : 2;
        sum += weight * f[static_cast<std::size_t>(k)] * std::cos(angle) * std::sin(angle) * angle;
    }
    return glm::two_pi<double>() * sum * step / 3;
}

Claim mirror(const LobeValues& values) {
    const double cone = glm::radians(10.0);
    const auto inside = [&](double n, bool normalize) {
        return energy_within(values, {"rational", n, 0, normalize}, cone);
    };
    // What a mirror of reflectance one sends elsewhere is nothing.
    const double raw_4 = 1 - inside(1e4, false), raw_8 = 1 - inside(1e8, false);
    const double part_4 = 1 - inside(1e4, true), part_8 = 1 - inside(1e8, true);
    const auto nears_none = [](double at_4, double at_8) {
        return at_8 < std::max(at_4, negligible) && at_8 < 0.5;
    };
    const bool raw = nears_none(raw_4, raw_8), normalized = nears_none(part_4, part_8);
    // Falling as 1 / (ln n - 1), it halves from 1e4 to 1e8: 8.2 to 17.4.
    const double rate = part_8 * (std::log(1e8) - 1) / (part_4 * (std::log(1e4) - 1));
    const bool slow = part_8 > negligible && rate > 0.5;
    Claim claim{"n_infinite_mirror", "n = infinity is a perfect mirror"};
    claim.holds = raw ? Holds::yes : normalized ? Holds::only_if : Holds::no;
    if (claim.holds == Holds::only_if)
        claim.condition =
            std::string("the lobe is normalised") + (slow ? ", and then only logarithmically" : "");
    claim.figures = formatted(
        "within 10 deg at n = 1e4, 1e8: %.2g, %.2g of the light with ks = 1; normalised %.1f "
        "%%, %.1f %%",
        inside(1e4, false), inside(1e8, false), 100 * (1 - part_4), 100 * (1 - part_8));
    if (normalized && slow)
        claim.figures += formatted("; 99 %% would need n = 1e%.0f",
                                   (part_8 * (std::log(1e8) - 1) / 0.01 + 1) / std::log(10.0));
    return claim;
}

Claim listing(const LobeValues& values) {
    const std::vector<DirectionsPair> pairs = all_over();
    const std::vector<double> formula = values({"rational", 100, 0}, pairs);
    const std::vector<double> listed = values({"rational", 100, 2}, pairs);
    const double peak = *std::max_element(formula.begin(), formula.end());
    double most = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        most = std::max(most, std::abs(listed[i] - formula[i]) / peak);
    const double s = std::sqrt(0.5);
    const std::vector<DirectionsPair> mirrored = {{{s, 0, s}, {-s, 0, s}}};
    Claim claim{"listing_equals_formula", "the listing computes the formula"};
    claim.holds = most < negligible ? Holds::yes : Holds::no;
    claim.figures = formatted(
        "n = 100: they differ by up to %.2g times the peak; into the mirror "
        "direction at 45 deg the formula gives %.3g, the listing %.3g",
        most, values({"rational", 100, 0}, mirrored)[0], values({"rational", 100, 2}, mirrored)[0]);
    return claim;
}

}  // namespace

std::vector<Claim> judge_model_claims(const LobeValues& values) {
    return {slower(values, "modified_phong", "slower_darkening",
                   "off the mirror direction the lobe darkens more slowly than cos^n"),
            slower(values, "phong", "slower_darkening_phong",
                   "it darkens more slowly than Phong's BRDF, cos^n over the light's cosine"),
            larger_n(values),
            diffuse(values),
            mirror(values),
            listing(values)};
}

}  // namespace lobe
