// SPDX-License-Identifier: Apache-2.0
#include "lab/measure/matching.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace lobe {

const std::array<Criterion, 5> criteria = {{{"peak curvature", &LobeShape::curvature},
                                            {"half-width", &LobeShape::half_width},
                                            {"lobe integral", &LobeShape::integral},
                                            {"normal albedo", &LobeShape::albedo},
                                            {"median energy", &LobeShape::median}}};

std::string Sharpened::name() const {
    std::string all;
    for (const std::size_t place : parameters)
        all += (all.empty() ? "" : "=") + subject.model.parameters[place].name;
    return all;
}

void Sharpened::set(const std::vector<double>& values) const {
    std::vector<BrdfRows> sets(values.size(), subject.rows);
    for (std::size_t i = 0; i < values.size(); ++i)
        for (const std::size_t place : parameters)
            sets[i][place] = {static_cast<float>(values[i]), 0, 0, 0};
    probe.set_parameters(sets, subject.tables);
}

std::vector<LobeShape> Sharpened::shapes(const std::vector<double>& values) const {
    set(values);
    return measure_lobe_shapes(probe, static_cast<std::uint32_t>(values.size()));
}

std::vector<double> Sharpened::scan() const {
    const bool open = std::isinf(row().highest);
    const double high = open ? 1e16 : row().highest;
    const double low = std::max(row().lowest, open ? 1e-3 : 1e-5 * high);
    const int steps = static_cast<int>(std::ceil(4 * std::log10(high / low)));
    std::vector<double> values;
    for (int k = 0; k <= steps; ++k)
        values.push_back(low * std::pow(high / low, k / double(steps)));
    return values;
}

namespace {

std::vector<double> in_range(const BrdfParameter& row, const std::vector<double>& values) {
    std::vector<double> out;
    for (const double v : values)
        if (v >= row.lowest && v <= row.highest) out.push_back(v);
    return out;
}

// Of `values`, or of multiples of the default where the row's range ends, those in the range.
std::vector<double> within(const BrdfParameter& row, const std::vector<double>& values,
                           const std::vector<double>& multiples) {
    if (std::isinf(row.highest)) return in_range(row, values);
    std::vector<double> scaled;
    const double middle = row.standard > 0 ? row.standard : 0.1 * row.highest;
    for (const double m : multiples) scaled.push_back(m * middle);
    return in_range(row, scaled);
}

}  // namespace

std::vector<double> Sharpened::examples() const {
    return within(row(), {1, 2, 5, 10, 100, 1e3, 1e4, 1e6}, {0.125, 0.25, 0.5, 1, 2, 4, 8});
}

std::vector<double> Sharpened::few() const {
    return within(row(), {0.1, 1, 10, 100, 1000}, {0.25, 0.5, 1, 2, 4});
}

namespace {

// How many times the quantity's least value the largest is, over the parameter's examples.
double effect(BrdfProbe& probe, const Subject& subject, std::size_t place,
              double LobeShape::*quantity) {
    const Sharpened candidate{probe, subject, {place}};
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for (const LobeShape& shape : candidate.shapes(candidate.examples())) {
        if (!(shape.*quantity > 0)) continue;
        low = std::min(low, shape.*quantity);
        high = std::max(high, shape.*quantity);
    }
    return high / low;
}

bool alike(const BrdfParameter& a, const BrdfParameter& b) {
    return a.kind == b.kind && a.standard == b.standard && a.lowest == b.lowest &&
           a.highest == b.highest;
}

}  // namespace

std::vector<std::size_t> shaping_parameters(BrdfProbe& probe, const Subject& subject,
                                            const std::string& name) {
    const std::vector<BrdfParameter>& rows = subject.model.parameters;
    double most = 2;  // a width that changes less is not shaped
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].kind != BrdfParameterKind::number) continue;
        if (!name.empty() && rows[i].name != name) continue;
        const double change = effect(probe, subject, i, &LobeShape::half_width);
        if (change <= most) continue;
        most = change;
        places = {i};
    }
    if (places.empty() || !name.empty()) return places;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (i != places[0] && alike(rows[i], rows[places[0]]) &&
            effect(probe, subject, i, &LobeShape::integral) > 1.5)
            places.push_back(i);
    return places;
}

Sharpened find_sharpness(BrdfProbe& probe, const Subject& subject, const std::string& name) {
    const std::vector<std::size_t> places = shaping_parameters(probe, subject, name);
    if (places.empty())
        throw Error(ExitCode::usage,
                    "model '" + subject.model.name + "' has no " +
                        (name.empty() ? "parameter" : "parameter '" + name + "'") +
                        " that shapes a lobe about the mirror direction",
                    "", "lobe brdf plot --kind curves shows the lobes that models have");
    return {probe, subject, places};
}

namespace {

// A root between two values of the parameter; a and b are logarithms, and fa and fb by how much the
// quantity's logarithm is too large there.
struct Search {
    std::size_t match, criterion;
    double wanted;  // logarithm of the quantity
    double a, b, fa, fb;
    int side = 0;

    // Where regula falsi looks next, with the Illinois trick against one end staying for ever.
    double next() const { return b - fb * (b - a) / (fb - fa); }
    void take(double x, double f) {
        if ((f > 0) == (fb > 0)) {
            b = x;
            fb = f;
            if (side == 1) fa *= 0.5;
            side = 1;
        } else {
            a = x;
            fa = f;
            if (side == -1) fb *= 0.5;
            side = -1;
        }
    }
};

// The brackets that a scan of the parameter's range shows.
std::vector<Search> find_brackets(const Sharpened& own, const std::vector<Match>& matches) {
    const std::vector<double> values = own.scan();
    const std::vector<LobeShape> shapes = own.shapes(values);
    std::vector<Search> found;
    for (std::size_t m = 0; m < matches.size(); ++m)
        for (std::size_t c = 0; c < criteria.size(); ++c) {
            const double wanted = std::log(matches[m].shape.*criteria[c].quantity);
            for (std::size_t k = 1; k < shapes.size(); ++k) {
                const double fa = std::log(shapes[k - 1].*criteria[c].quantity) - wanted;
                const double fb = std::log(shapes[k].*criteria[c].quantity) - wanted;
                if (!(fa * fb <= 0)) continue;  // nor where either is NaN
                found.push_back(
                    {m, c, wanted, std::log(values[k - 1]), std::log(values[k]), fa, fb});
                break;
            }
        }
    return found;
}

}  // namespace

std::vector<Match> match_lobes(const Sharpened& own, const Sharpened& other,
                               const std::vector<double>& values) {
    const std::vector<LobeShape> shapes = other.shapes(values);
    std::vector<Match> matches(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        matches[i] = {values[i], shapes[i], {}};
        matches[i].matched.fill(std::numeric_limits<double>::quiet_NaN());
    }
    std::vector<Search> searches = find_brackets(own, matches);
    constexpr int rounds = 9;
    for (int round = 0; round < rounds && !searches.empty(); ++round) {
        std::vector<double> tried;
        for (const Search& s : searches) tried.push_back(std::exp(s.next()));
        const std::vector<LobeShape> found = own.shapes(tried);
        for (std::size_t i = 0; i < searches.size(); ++i) {
            Search& s = searches[i];
            matches[s.match].matched[s.criterion] = tried[i];
            const double f = std::log(found[i].*criteria[s.criterion].quantity) - s.wanted;
            if (std::isfinite(f) && f != 0) s.take(std::log(tried[i]), f);
        }
    }
    return matches;
}

}  // namespace lobe
