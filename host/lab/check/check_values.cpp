// SPDX-License-Identifier: Apache-2.0
// Values at single pairs of directions: both ways round, against the printed formula, in float
// against double, and a sample's weight against the functions it must agree with.
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "lab/check/check_context.h"

namespace lobe {
namespace {

// Below this float keeps no digits.
constexpr double vanishing = 1e-36;

// How far values move when every input moves by up to half a float's last place: what no float
// arithmetic on these inputs can be better than.
struct Conditioning {
    std::vector<double> f, pdf;
};

class ValueChecks {
  public:
    explicit ValueChecks(CheckContext& context)
        : context_(context),
          precise_(context.oracle ? *context.oracle : context.probe),
          reciprocity_("reciprocity", context.oracle ? 1e-6 : 5e-3) {
        formula_.limit = 2e-6;
        precision_.limit = weight_.limit = samples_.limit = 1;
        precision_.note = "error over allowance: 8 times the conditioning, and 2e-5";
        weight_.note = precision_.note;
        if (!context.model.has_formula) formula_.skipped = "the model prints none";
        if (!context.oracle) {
            const std::string reason = "the device has no cl_khr_fp64";
            formula_.skipped = precision_.skipped = samples_.skipped = reason;
        }
    }

    void run() {
        const BrdfQuery query = pairs();
        const std::vector<BrdfValue> exact = precise_.eval(query);
        const Conditioning conditioning = measure_conditioning(query, exact);
        if (context_.oracle) {
            check_precision(query, exact, conditioning);
            if (context_.model.has_formula) check_formula(query);
        }
        check_reciprocity(query, exact);
        check_weights();
    }

    std::vector<Finding> finish() {
        return {formula_, precision_, samples_, weight_,
                reciprocity_.finish("reciprocal", context_.options.effort.both_ways)};
    }

  private:
    // For every case: directions drawn by the model, even ones, grazing ones, and ones close to the
    // mirror direction, where lobes are sharp.
    BrdfQuery pairs() {
        const std::size_t each = context_.options.effort.directions;
        BrdfQuery query;
        Random random(context_.options.seed + 17);
        const BrdfQuery numbers = sample_numbers(each, 23);
        const std::vector<BrdfSampled> drawn = context_.probe.sample(numbers);
        for (std::size_t i = 0; i < context_.cases.size(); ++i) {
            const CheckCase& c = context_.cases[i];
            const auto add = [&](const glm::dvec3& wi) {
                const glm::dvec3 held = rounded(wi);
                if (!(held.z > 0)) return;
                query.add(c.set, c.wo, held);
                cases_.push_back(i);
            };
            for (std::size_t k = 0; k < each; ++k) {
                const glm::dvec3 mirror(-c.wo.x, -c.wo.y, c.wo.z);
                const double azimuth = random.uniform(0, glm::two_pi<double>());
                add(drawn[i * each + k].wi);
                add(direction(random.uniform(), azimuth));
                add(direction(random.log_uniform(1e-12, 1e-2), azimuth));
                const glm::dvec3 off(random.normal(), random.normal(), random.normal());
                add(glm::normalize(mirror + random.log_uniform(1e-7, 0.5) * off));
            }
        }
        return query;
    }

    static glm::dvec3 direction(double z, double azimuth) {
        const double r = std::sqrt((1 - z) * (1 + z));
        return {r * std::cos(azimuth), r * std::sin(azimuth), z};
    }

    BrdfQuery sample_numbers(std::size_t each, std::uint64_t stream) const {
        BrdfQuery query;
        Random random(context_.options.seed * 77 + stream);
        for (const CheckCase& c : context_.cases)
            for (std::size_t k = 0; k < each; ++k)
                query.add(c.set, c.wo,
                          {random.uniform_float(), random.uniform_float(), random.uniform_float()});
        return query;
    }

    Conditioning measure_conditioning(const BrdfQuery& query,
                                      const std::vector<BrdfValue>& exact) const {
        Conditioning result{std::vector<double>(query.size()), std::vector<double>(query.size())};
        Random random(context_.options.seed + 29);
        const auto moved = [&](const glm::dvec3& v) {
            glm::dvec3 out;
            for (int k = 0; k < 3; ++k)
                out[k] = v[k] * (1 + (random.below(2) ? 0x1p-24 : -0x1p-24));
            return out;
        };
        for (int time = 0; time < 8; ++time) {
            BrdfQuery near;
            for (std::size_t i = 0; i < query.size(); ++i)
                near.add(query.sets[i], moved(query.wo[i]), moved(query.second[i]));
            const std::vector<BrdfValue> values = precise_.eval(near);
            for (std::size_t i = 0; i < values.size(); ++i) {
                const glm::dvec3 d = glm::abs(values[i].f - exact[i].f);
                result.f[i] = std::max({result.f[i], d.x, d.y, d.z});
                result.pdf[i] = std::max(result.pdf[i], std::abs(values[i].pdf - exact[i].pdf));
            }
        }
        return result;
    }

    const std::string& text(std::size_t item) const { return context_.cases[cases_[item]].text; }

    void check_precision(const BrdfQuery& query, const std::vector<BrdfValue>& exact,
                         const Conditioning& conditioning) {
        const std::vector<BrdfValue> values = context_.probe.eval(query);
        for (std::size_t i = 0; i < values.size(); ++i) {
            for (int k = 0; k < 3; ++k)
                precision_.see(excess(values[i].f[k], exact[i].f[k], conditioning.f[i]), text(i));
            precision_.see(excess(values[i].pdf, exact[i].pdf, conditioning.pdf[i]), text(i));
        }
        // With the same numbers both builds go the same way, but where rounding tips a choice.
        const BrdfQuery numbers = sample_numbers(context_.options.effort.directions, 31);
        const std::vector<BrdfSampled> single = context_.probe.sample(numbers);
        const std::vector<BrdfSampled> twice = context_.oracle->sample(numbers);
        const std::size_t each = context_.options.effort.directions;
        for (std::size_t c = 0; c < context_.cases.size(); ++c) {
            double differ = 0;
            for (std::size_t i = c * each; i < (c + 1) * each; ++i)
                differ += glm::distance(single[i].wi, twice[i].wi) > 5e-3;
            samples_.see(differ / (1 + 0.05 * static_cast<double>(each)), context_.cases[c].text);
        }
        samples_.note = "directions that differ from double's by 5e-3, over one and 5 %";
    }

    static double excess(double value, double exact, double conditioning) {
        const double error = std::abs(value - exact);
        return error / (allowed_conditionings * conditioning + allowed_rounding * std::abs(exact) +
                        vanishing);
    }

    // On vectors that are unit vectors in double: a formula may take that for granted.
    void check_formula(const BrdfQuery& held) {
        BrdfQuery query;
        for (std::size_t i = 0; i < held.size(); ++i)
            query.add(held.sets[i], glm::normalize(held.wo[i]), glm::normalize(held.second[i]));
        const std::vector<BrdfValue> values = context_.oracle->eval(query);
        const std::vector<glm::dvec3> printed = context_.oracle->formula(query);
        for (std::size_t i = 0; i < printed.size(); ++i)
            for (int k = 0; k < 3; ++k) {
                const double expected = printed[i][k] * query.second[i].z;
                if (!std::isfinite(expected)) continue;  // the report on extremes counts these
                const double size = std::abs(expected) + std::abs(values[i].f[k]) + vanishing;
                formula_.see(std::abs(values[i].f[k] - expected) / size, text(i));
            }
    }

    void check_reciprocity(const BrdfQuery& query, const std::vector<BrdfValue>& exact) {
        BrdfQuery turned;
        for (std::size_t i = 0; i < query.size(); ++i)
            turned.add(query.sets[i], query.second[i], query.wo[i]);
        const std::vector<BrdfValue> back = precise_.eval(turned);
        for (std::size_t i = 0; i < back.size(); ++i) {
            // f(wo, wi) = f(wi, wo), both times both cosines: no division by a grazing one.
            const double there = mean_channel(exact[i].f) * query.wo[i].z;
            const double here = mean_channel(back[i].f) * query.second[i].z;
            const double violation = std::abs(there - here) / (std::max(there, here) + vanishing);
            reciprocity_.see(context_.claims(context_.cases[cases_[i]]).reciprocal, violation,
                             text(i));
        }
    }

    // weight * pdf = f cos, and the sample's pdf is the one pdf() gives for its direction.
    void check_weights() {
        const BrdfQuery numbers = sample_numbers(context_.options.effort.directions, 37);
        const std::vector<BrdfSampled> samples = context_.probe.sample(numbers);
        BrdfQuery query;
        std::vector<std::size_t> of;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (samples[i].delta || !(samples[i].pdf > 0) || !(samples[i].wi.z > 0)) continue;
            query.add(numbers.sets[i], numbers.wo[i], samples[i].wi);
            of.push_back(i);
        }
        const Conditioning conditioning = measure_conditioning(query, precise_.eval(query));
        const std::vector<BrdfValue> values = context_.probe.eval(query);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const BrdfSampled& s = samples[of[i]];
            const std::string& place =
                context_.cases[of[i] / context_.options.effort.directions].text;
            weight_.see(excess(s.pdf, values[i].pdf, conditioning.pdf[i]), place);
            const double of_f = conditioning.f[i] + conditioning.pdf[i] * mean_channel(s.weight);
            for (int k = 0; k < 3; ++k)
                weight_.see(excess(s.weight[k] * s.pdf, values[i].f[k], of_f), place);
        }
    }

    CheckContext& context_;
    const BrdfProbe& precise_;
    std::vector<std::size_t> cases_;  // of each pair
    Finding formula_{"formula"}, precision_{"precision"}, samples_{"same samples"};
    Finding weight_{"weight"};
    ClaimTest reciprocity_;
};

}  // namespace

std::vector<Finding> check_values(CheckContext& context) {
    ValueChecks checks(context);
    checks.run();
    return checks.finish();
}

}  // namespace lobe
