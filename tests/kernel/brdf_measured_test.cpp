// SPDX-License-Identifier: Apache-2.0
// The measured model on the device: values against a table read by hand in long double, densities
// and samples for tables of all shapes.
#include <gtest/gtest.h>

#include "base/random.h"
#include "base/statistics.h"
#include "kernel/brdf_grid.h"
#include "kernel/brdf_probe.h"
#include "scene/measured.h"
#include "support/chi_square.h"

using namespace lobe;
using namespace lobe::test;

namespace {

const BrdfTable& model() {
    static const BrdfTable table =
        parse_brdf_table("brdf/measured.h", KernelText().read("brdf/measured.h"));
    return table;
}

// One program for all tests of a precision.
BrdfProbe& probe_of(Precision precision) {
    static BrdfProbe single(test_device(), KernelText(), model());
    if (precision == Precision::single) return single;
    static BrdfProbe twice(test_device(), KernelText(), model(), Precision::twice);
    return twice;
}

BrdfProbe& with(const MeasuredBrdf& table, Precision precision = Precision::single) {
    BrdfProbe& probe = probe_of(precision);
    probe.set_parameters({model().default_rows()}, lay_out(table));
    return probe;
}

template <typename Value>
MeasuredBrdf make_table(std::array<std::uint32_t, 3> counts, const Value& value) {
    MeasuredBrdf table;
    table.counts = counts;
    for (std::uint32_t i = 0; i < counts[0]; ++i)
        for (std::uint32_t j = 0; j < counts[1]; ++j)
            for (std::uint32_t k = 0; k < counts[2]; ++k) table.values.push_back(value(i, j, k));
    return table;
}

// Every cell another number, within a factor of three.
MeasuredBrdf noisy_table(std::array<std::uint32_t, 3> counts) {
    Random random(77);
    return make_table(counts, [&](auto...) {
        return glm::vec3(random.uniform(1, 3), random.uniform(1, 3), random.uniform(1, 3));
    });
}

// A peak of some 1e-3 radians, as of polished metal, over little else.
MeasuredBrdf sharp_table() {
    return make_table({90, 6, 4}, [](std::uint32_t i, std::uint32_t j, std::uint32_t) {
        return glm::vec3(static_cast<float>(3000 * std::exp(-0.4 * i) * (1 + 0.2 * j) + 0.01));
    });
}

// As floats hold it. GCC 12 takes both conversions out of a whole vector at once (-O2 -fPIC).
glm::dvec3 held(const glm::dvec3& v) {
    glm::dvec3 out;
    for (int k = 0; k < 3; ++k) {
        const volatile auto rounded = static_cast<float>(v[k]);
        out[k] = static_cast<double>(rounded);
    }
    return out;
}

glm::dvec3 random_direction(Random& random) {
    return held(
        glm::dvec3(direction(std::acos(Long(random.uniform(0.01, 1))), random.uniform(0, 6.283))));
}

BrdfQuery random_pairs(std::size_t count) {
    Random random(5);
    BrdfQuery query;
    while (query.size() < count) {
        const glm::dvec3 wo = random_direction(random);
        const glm::dvec3 off(random.normal(), random.normal(), random.normal());
        const glm::dvec3 near = held(
            glm::normalize(glm::dvec3(-wo.x, -wo.y, wo.z) + random.log_uniform(1e-3, 0.3) * off));
        const glm::dvec3 wi = query.size() % 2 ? random_direction(random) : near;
        if (wi.z > 0.01) query.add(0, wo, wi);
    }
    return query;
}

// The angles by turning the frame onto the half vector, as the source of the table's layout does.
std::array<Long, 3> angles_of(const vec3l& wo, const vec3l& wi) {
    const vec3l h = glm::normalize(glm::normalize(wo) + glm::normalize(wi)), w = glm::normalize(wi);
    const Long theta = std::acos(std::min(1.0L, h.z)), phi = std::atan2(h.y, h.x);
    const Long c = std::cos(phi), s = std::sin(phi);
    const vec3l turned(c * w.x + s * w.y, -s * w.x + c * w.y, w.z);
    const vec3l d(std::cos(theta) * turned.x - std::sin(theta) * turned.z, turned.y,
                  std::sin(theta) * turned.x + std::cos(theta) * turned.z);
    Long phi_d = std::atan2(d.y, d.x);
    if (phi_d < 0) phi_d += pi;
    return {theta, std::acos(std::min(1.0L, d.z)), phi_d};
}

// A hat function about the middle of cell i of n.
Long hat(Long at, std::uint32_t i, std::uint32_t n, bool periodic) {
    Long x = at * n - 0.5L;
    if (periodic && n == 1) return 1;
    if (periodic) return std::max(0.0L, 1 - std::fabs(std::remainder(x - i, Long(n))));
    x = std::clamp(x, 0.0L, n - 1.0L);
    return std::max(0.0L, 1 - std::fabs(x - i));
}

vec3l oracle(const MeasuredBrdf& table, const vec3l& wo, const vec3l& wi) {
    const auto [theta_h, theta_d, phi_d] = angles_of(wo, wi);
    const auto& n = table.counts;
    vec3l sum(0);
    std::size_t cell = 0;
    for (std::uint32_t i = 0; i < n[0]; ++i)
        for (std::uint32_t j = 0; j < n[1]; ++j)
            for (std::uint32_t k = 0; k < n[2]; ++k)
                sum += vec3l(table.values[cell++]) *
                       (hat(std::sqrt(theta_h / (pi / 2)), i, n[0], false) *
                        hat(theta_d / (pi / 2), j, n[1], false) * hat(phi_d / pi, k, n[2], true));
    return sum;
}

double difference(const glm::dvec3& f, const vec3l& exact) {
    double worst = 0;
    for (int k = 0; k < 3; ++k) worst = std::max(worst, relative_error(f[k], exact[k]));
    return worst;
}

}  // namespace

TEST(BrdfMeasured, TheMiddleOfACellHasItsValue) {
    const MeasuredBrdf table = noisy_table({9, 7, 8});
    BrdfQuery query;
    std::vector<std::size_t> cells;
    for (std::size_t cell = 0; cell < table.cells(); ++cell) {
        const DirectionPair pair = directions_at(table, cell);
        if (!(pair.wo.z > 0.01 && pair.wi.z > 0.01)) continue;
        query.add(0, held(pair.wo), held(pair.wi));
        cells.push_back(cell);
    }
    EXPECT_GT(cells.size(), table.cells() / 3);
    const std::vector<BrdfValue> values = with(table).eval(query);
    for (std::size_t i = 0; i < cells.size(); ++i)
        EXPECT_LE(difference(values[i].f / query.second[i].z, vec3l(table.values[cells[i]])), 1e-4)
            << cells[i];
}

namespace {

const std::array<std::uint32_t, 3> all_counts[] = {{9, 7, 8}, {1, 1, 1}, {16, 2, 1}, {1, 5, 3}};

}  // namespace

// On unit vectors: floats are that but for 1e-7, and angles of small half vectors feel it.
TEST(BrdfMeasured, BetweenCellsItIsTrilinear) {
    const BrdfQuery query = random_pairs(500);
    BrdfQuery unit;
    for (std::size_t i = 0; i < query.size(); ++i)
        unit.add(0, glm::normalize(query.wo[i]), glm::normalize(query.second[i]));
    for (const auto& counts : all_counts) {
        const MeasuredBrdf table = noisy_table(counts);
        std::vector<BrdfValue> values;
        if (test_device().info().fp64) values = with(table, Precision::twice).eval(unit);
        double host = 0, device = 0;
        for (std::size_t i = 0; i < unit.size(); ++i) {
            const glm::dvec3 &wo = unit.wo[i], &wi = unit.second[i];
            const vec3l exact = oracle(table, wo, wi);
            host = std::max(host, difference(interpolate(table, wo, wi), exact));
            if (!values.empty()) device = std::max(device, difference(values[i].f / wi.z, exact));
        }
        EXPECT_LE(host, 1e-9);
        EXPECT_LE(device, 1e-9);
    }
}

TEST(BrdfMeasured, FloatIsAsGoodAsItsInput) {
    const BrdfQuery query = random_pairs(4000);
    for (const auto& counts : all_counts) {
        const MeasuredBrdf table = noisy_table(counts);
        const std::vector<BrdfValue> values = with(table).eval(query);
        double worst = 0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const vec3l exact(interpolate(table, query.wo[i], query.second[i]));
            worst = std::max(worst, difference(values[i].f / query.second[i].z, exact));
        }
        EXPECT_LE(worst, 1e-5);
    }
}

// Both directions exchanged: the same value, to the rounding of the last product.
TEST(BrdfMeasured, IsReciprocal) {
    const BrdfQuery query = random_pairs(2000);
    BrdfQuery turned;
    for (std::size_t i = 0; i < query.size(); ++i) turned.add(0, query.second[i], query.wo[i]);
    const MeasuredBrdf table = noisy_table({9, 7, 8});
    const std::vector<BrdfValue> there = with(table).eval(query), back = with(table).eval(turned);
    for (std::size_t i = 0; i < there.size(); ++i)
        EXPECT_LE(difference(there[i].f / query.second[i].z, vec3l(back[i].f / query.wo[i].z)),
                  3e-7);
}

// An angle from its cosine would be wrong by 3e-4 radians here, more than the peak is wide.
TEST(BrdfMeasured, FloatSeesTheSharpestPeak) {
    LOBE_NEEDS_DOUBLE();
    const MeasuredBrdf table = sharp_table();
    BrdfQuery query;
    Random random(8);
    for (int i = 0; i < 4000; ++i) {
        const glm::dvec3 wo = random_direction(random);
        const double far = random.log_uniform(2e-6, 0.02), turn = random.uniform(0, 6.283);
        const glm::dvec3 h(std::sin(far) * std::cos(turn), std::sin(far) * std::sin(turn),
                           std::cos(far));
        const glm::dvec3 wi = held(2 * glm::dot(wo, h) * h - wo);
        if (wi.z > 0.01) query.add(0, wo, wi);
    }
    const std::vector<BrdfValue> single = with(table).eval(query);
    const std::vector<BrdfValue> twice = with(table, Precision::twice).eval(query);
    for (std::size_t i = 0; i < query.size(); ++i) {
        EXPECT_LE(difference(single[i].f, vec3l(twice[i].f)), 3e-5);
        EXPECT_LE(relative_error(single[i].pdf, twice[i].pdf), 3e-5);
    }
}

TEST(BrdfMeasured, ScaleIsAFactor) {
    BrdfProbe& probe = probe_of(Precision::single);
    BrdfRows doubled = model().default_rows();
    doubled[1] = {2, 1, 0, 0};
    probe.set_parameters({doubled}, made_up_table());
    const BrdfQuery query = random_pairs(100);
    const std::vector<BrdfValue> scaled = probe.eval(query);
    const std::vector<BrdfValue> plain = with(made_up_material()).eval(query);
    for (std::size_t i = 0; i < query.size(); ++i)
        EXPECT_EQ(scaled[i].f, plain[i].f * glm::dvec3(2, 1, 0));
}

// A row's value is where its table begins.
TEST(BrdfMeasured, TablesLieOneAfterTheOther) {
    std::vector<float> tables = made_up_table();
    const auto second = static_cast<std::uint32_t>(tables.size());
    const std::vector<float> white =
        lay_out(make_table({1, 1, 1}, [](auto...) { return glm::vec3(1, 2, 3); }));
    tables.insert(tables.end(), white.begin(), white.end());
    BrdfRows rows = model().default_rows();
    std::memcpy(&rows[0][0], &second, sizeof second);
    BrdfProbe& probe = probe_of(Precision::single);
    probe.set_parameters({model().default_rows(), rows}, tables);
    BrdfQuery query;
    query.add(1, {0, 0, 1}, {0.6, 0, 0.8});
    query.add(0, {0, 0, 1}, {0.6, 0, 0.8});
    const std::vector<BrdfValue> values = probe.eval(query);
    EXPECT_NEAR(values[0].f.y, 2 * 0.8, 1e-6);
    EXPECT_NE(values[0].f.y, values[1].f.y);
}

namespace {

struct Shape {
    const char* name;
    MeasuredBrdf table;
};

std::vector<Shape> shapes() {
    const auto constant = [](float v) { return [v](auto...) { return glm::vec3(v); }; };
    return {
        {"made up", made_up_material()},
        {"lambert", make_table({8, 4, 4}, constant(0.25f))},
        {"one cell", make_table({1, 1, 1}, constant(0.1f))},
        {"zero", make_table({4, 4, 4}, constant(0))},
        {"one huge cell", make_table({8, 8, 8},
                                     [](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
                                         return glm::vec3(i == 4 && j == 2 && k == 2 ? 1e30f : 0);
                                     })},
        {"sharp", sharp_table()}};
}

}  // namespace

TEST(BrdfMeasured, DensityIsWhatIsSampled) {
    const std::vector<Shape> all = shapes();
    const double degrees[] = {0.05, 45, 80};
    const double tests = 2.0 * 3 * static_cast<double>(all.size());
    constexpr std::size_t count = 60000;
    for (const Shape& shape : all)
        for (const double angle : degrees) {
            SCOPED_TRACE(std::string(shape.name) + " at " + std::to_string(angle));
            const vec3l wo(glm::vec3(direction(radians(angle))));
            const BrdfProbe& probe = with(shape.table);
            BrdfQuery numbers, nodes;
            Random random(31);
            for (std::size_t i = 0; i < count; ++i)
                numbers.add(
                    0, wo,
                    {random.uniform_float(), random.uniform_float(), random.uniform_float()});
            const HemisphereGrid grid(wo, rings_of_width(1e-5L), 24);
            for (const vec3l& wi : grid.nodes) nodes.add(0, wo, wi);
            const std::vector<BrdfValue> values = probe.eval(nodes);
            std::vector<double> expected(grid.cells() + 1), counts(grid.cells() + 1), weights;
            double mass = 0, albedo = 0;
            for (std::size_t i = 0; i < values.size(); ++i) {
                const double w = static_cast<double>(grid.weights[i]);
                expected[grid.node_cells[i]] += count * values[i].pdf * w;
                mass += values[i].pdf * w;
                albedo += values[i].f.x * w;
            }
            for (const BrdfSampled& s : probe.sample(numbers)) {
                ++counts[s.pdf > 0 ? grid.cell_of(vec3l(s.wi)) : grid.cells()];
                weights.push_back(s.weight.x);
            }
            const double lost = counts.back() / count;
            expected.back() = std::max(0.0, count * (1 - mass));
            EXPECT_TRUE(follows(counts, expected, tests));
            EXPECT_NEAR(mass, 1 - lost, 1e-3 + 5 * std::sqrt(lost / count));
            const double error = std::hypot(standard_error(weights), 1e-3 * albedo);
            if (albedo > 0) {
                EXPECT_TRUE(normal_deviate((mean(weights) - albedo) / error, tests))
                    << albedo << " " << mean(weights);
            }
        }
}

TEST(BrdfMeasured, ExtremesAreFinite) {
    BrdfQuery values, samples;
    for (const double z : {1.0, 0.7, 1e-3, 1e-10, 1e-20, 1.2e-38}) {
        const double r = std::sqrt((1 - z) * (1 + z));
        const glm::dvec3 wo = held({r, 0, z});
        for (const double other : {1.0, 1e-3, 1e-10, 1e-20, 1.2e-38})
            for (const double side : {-1.0, 1.0})
                values.add(0, wo, held({side * std::sqrt((1 - other) * (1 + other)), 0, other}));
        values.add(0, wo, held({-r, 0, z}));
        for (const double a : {0.0, 0x1p-24, 0.5, 1 - 0x1p-24})
            for (const double b : {0.0, 0.5, 1 - 0x1p-24})
                for (const double c : {0.0, 0.5, 1 - 0x1p-24}) samples.add(0, wo, {a, b, c});
    }
    for (const Shape& shape : shapes()) {
        const BrdfProbe& probe = with(shape.table);
        for (const BrdfValue& v : probe.eval(values)) {
            EXPECT_TRUE(std::isfinite(v.f.x + v.f.y + v.f.z + v.pdf)) << shape.name;
            EXPECT_GE(std::min({v.f.x, v.f.y, v.f.z, v.pdf}), 0) << shape.name;
        }
        for (const BrdfSampled& s : probe.sample(samples)) {
            EXPECT_TRUE(std::isfinite(s.weight.x + s.pdf + s.wi.x)) << shape.name;
            EXPECT_GE(std::min(s.weight.x, s.pdf), 0) << shape.name;
            EXPECT_TRUE(s.weight.x == 0 || s.wi.z > 0) << shape.name;
        }
    }
}
