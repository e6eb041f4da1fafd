// SPDX-License-Identifier: Apache-2.0
// What samples do against what the density and the values say, for each parameter set and angle.
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "base/chi_square.h"
#include "base/statistics.h"
#include "lab/check/check_context.h"
#include "lab/hemisphere.h"

namespace lobe {
namespace {

// Cases worked on at once: enough for a launch to be worth while, few enough for memory.
constexpr std::size_t batch = 24;

// What the samples of one case said.
struct Drawn {
    std::vector<double> counts;  // by cell, and last the lost ones
    std::vector<double> weights;
    double lost = 0, delta_share = 0, delta_albedo = 0;
    bool outside = false;  // below the horizon, or no unit vector
};

double square(double x) { return x * x; }

class SamplingChecks {
  public:
    SamplingChecks(CheckContext& context, ModelReport& report)
        : context_(context), report_(report), density_("density", 3e-4), energy_("energy", 1e-4) {
        albedo_.note = "mean weight against quadrature";
        variance_.limit = 6;
        resolved_.limit = effort().most_unresolved;
        resolved_.note = "share of cases too sharp for quadrature, which are not judged by it";
        variance_.note = "deviation of the weight over the albedo, or over 0.05";
        horizon_.limit = 0;
    }

    void run() {
        for (std::size_t first = 0; first < context_.cases.size(); first += batch) {
            const std::size_t last = std::min(first + batch, context_.cases.size());
            run_batch(first, last);
        }
    }

    std::vector<Finding> finish() {
        resolved_.worst = static_cast<double>(unresolved_) /
                          std::max<double>(1, static_cast<double>(resolved_.tests));
        return {horizon_, density_.finish("keeping all samples", effort().both_ways), chi_square_,
                albedo_,  energy_.finish("conserving energy", effort().both_ways),    variance_,
                resolved_};
    }

  private:
    const CheckEffort& effort() const { return context_.options.effort; }
    const CheckCase& at(std::size_t i) const { return context_.cases[i]; }
    // Azimuth of the mirror direction: a lobe there is not cut in two.
    static double towards(const CheckCase& c) { return std::atan2(-c.wo.y, -c.wo.x); }

    std::vector<BrdfSampled> draw(std::size_t first, std::size_t last, std::size_t count,
                                  std::uint64_t stream) {
        BrdfQuery query;
        for (std::size_t i = first; i < last; ++i) {
            Random random(context_.options.seed * 1000003 + stream * 8191 + i);
            for (std::size_t k = 0; k < count; ++k)
                query.add(at(i).set, at(i).wo,
                          {random.uniform_float(), random.uniform_float(), random.uniform_float()});
        }
        return context_.probe.sample(query);
    }

    // Points near the directions where models have their peaks, ever denser towards them, and an
    // even background: what samples may miss.
    std::vector<glm::dvec2> lookout(const CheckCase& c) const {
        std::vector<glm::dvec2> points;
        Random random(3);
        const double elevation = std::asin(std::min(1.0, c.wo.z));
        for (const glm::dvec2 peak : {glm::dvec2(elevation, 0), glm::dvec2(elevation, 3)})
            for (std::size_t k = 0; k < effort().lookout; ++k) {
                const double far = random.log_uniform(1e-4, 1), turn = random.uniform(0, 6.3);
                const glm::dvec2 p = peak + far * glm::dvec2(std::sin(turn), std::cos(turn));
                if (p.x > 0 && p.x < glm::half_pi<double>() && std::abs(p.y) < 3.14)
                    points.push_back(p);
            }
        const int rows = effort().lookout < 100 ? 2 : 8;
        for (int i = 0; i < rows; ++i)
            for (int j = 0; j < 2 * rows; ++j)
                points.push_back({(i + 0.5) / rows * glm::half_pi<double>(),
                                  ((j + 0.5) / rows - 1) * glm::pi<double>()});
        return points;
    }

    // Cells as fine as the model's own samples are dense, for each case of a batch.
    std::vector<HemisphereCells> make_cells(std::size_t first, std::size_t last) {
        const std::vector<BrdfSampled> drawn = draw(first, last, effort().pilot, 0);
        BrdfQuery query;
        std::vector<std::vector<PilotPoint>> pilots(last - first);
        for (std::size_t i = first; i < last; ++i)
            for (const glm::dvec2& p : lookout(at(i))) {
                query.add(at(i).set, at(i).wo, direction_at(p.x, p.y + towards(at(i))));
                pilots[i - first].push_back({p, 0});
            }
        const std::vector<BrdfValue> seen = context_.probe.eval(query);
        std::size_t place = 0;
        std::vector<HemisphereCells> cells;
        for (std::size_t i = first; i < last; ++i) {
            std::vector<PilotPoint>& pilot = pilots[i - first];
            for (PilotPoint& point : pilot) point.z = seen[place++].pdf;
            for (std::size_t k = 0; k < effort().pilot; ++k) {
                const BrdfSampled& s = drawn[(i - first) * effort().pilot + k];
                if (s.wi.z > 0 && !s.delta && s.pdf > 0)
                    pilot.push_back({elevation_azimuth(s.wi, towards(at(i))), s.pdf});
            }
            cells.emplace_back(std::move(pilot), effort().cells);
        }
        return cells;
    }

    std::vector<HemisphereJob> jobs_for(std::size_t first, std::size_t last,
                                        const std::vector<HemisphereCells>& cells) const {
        std::vector<HemisphereJob> jobs(last - first);
        for (std::size_t i = first; i < last; ++i) {
            HemisphereJob& job = jobs[i - first];
            job.number = static_cast<std::uint32_t>(i);
            job.towards = towards(at(i));
            job.patches = cells[i - first].patches();
            job.pilot = cells[i - first].pilot();
        }
        return jobs;
    }

    // Density, value in three channels, and the second moment of the weight.
    std::vector<HemisphereJob::Values> seen_from_viewer(const HemisphereNodes& nodes) const {
        BrdfQuery query;
        for (std::size_t k = 0; k < nodes.jobs.size(); ++k)
            query.add(at(nodes.jobs[k]).set, at(nodes.jobs[k]).wo, nodes.directions[k]);
        std::vector<HemisphereJob::Values> values;
        for (const BrdfValue& v : context_.probe.eval(query)) {
            const double f = mean_channel(v.f);
            values.push_back({v.pdf, v.f.x, v.f.y, v.f.z, v.pdf > 0 ? f * (f / v.pdf) : 0});
        }
        return values;
    }

    // The albedo for light from the case's direction, gathered over all viewers.
    std::vector<HemisphereJob::Values> seen_from_light(const HemisphereNodes& nodes) const {
        BrdfQuery query;
        for (std::size_t k = 0; k < nodes.jobs.size(); ++k)
            query.add(at(nodes.jobs[k]).set, nodes.directions[k], at(nodes.jobs[k]).wo);
        const std::vector<BrdfValue> found = context_.probe.eval(query);
        std::vector<HemisphereJob::Values> values;
        for (std::size_t k = 0; k < found.size(); ++k) {
            const double turned = nodes.directions[k].z / at(nodes.jobs[k]).wo.z;
            const glm::dvec3 f = found[k].f * turned;
            values.push_back({0, f.x, f.y, f.z, 0});
        }
        return values;
    }

    Drawn tally(const CheckCase& c, const HemisphereCells& cells, const BrdfSampled* samples,
                std::size_t count) const {
        Drawn drawn;
        drawn.counts.assign(cells.count() + 1, 0);
        double deltas = 0, delta_albedo = 0;
        const double azimuth = towards(c);
        for (std::size_t k = 0; k < count; ++k) {
            const BrdfSampled& s = samples[k];
            const double weight = mean_channel(s.weight);
            drawn.weights.push_back(weight);
            const bool none = s.pdf == 0 && weight == 0;
            if (none) {
                ++drawn.counts.back();
                ++drawn.lost;
                continue;
            }
            if (!(s.wi.z > 0) || std::abs(glm::length(s.wi) - 1) > 1e-5) drawn.outside = true;
            if (s.delta) {
                ++deltas;
                drawn.delta_share = s.pdf;
                delta_albedo = weight * s.pdf;
            } else {
                ++drawn.counts[cells.cell_of(elevation_azimuth(s.wi, azimuth))];
            }
        }
        drawn.delta_albedo = deltas > 0 ? delta_albedo : 0;
        return drawn;
    }

    void run_batch(std::size_t first, std::size_t last) {
        const std::size_t count = effort().samples;
        const std::vector<HemisphereCells> cells = make_cells(first, last);
        CubatureOptions cubature;
        cubature.relative = 0.04 * effort().resolution;
        cubature.nodes_a_job = effort().nodes;
        std::vector<HemisphereJob> jobs = jobs_for(first, last, cells);
        integrate(
            jobs, [&](const HemisphereNodes& n) { return seen_from_viewer(n); }, cubature);
        const std::vector<BrdfSampled> samples = draw(first, last, count, 1);
        for (std::size_t i = first; i < last; ++i)
            judge_case(at(i), jobs[i - first],
                       tally(at(i), cells[i - first], &samples[(i - first) * count], count));
        light_side(first, last, cells, cubature);
    }

    // Only a model that is not reciprocal can reflect more light than its viewers' side shows.
    void light_side(std::size_t first, std::size_t last, const std::vector<HemisphereCells>& cells,
                    const CubatureOptions& cubature) {
        std::vector<HemisphereJob> jobs;
        for (HemisphereJob& job : jobs_for(first, last, cells))
            if (!context_.claims(at(job.number)).reciprocal) jobs.push_back(std::move(job));
        for (HemisphereJob& job : jobs)
            for (PilotPoint& point : job.pilot) point.z = 0;  // of the viewer's side
        integrate(
            jobs, [&](const HemisphereNodes& n) { return seen_from_light(n); }, cubature);
        for (const HemisphereJob& job : jobs)
            judge_energy(at(job.number), job, 0, " from the light");
    }

    void judge_energy(const CheckCase& c, const HemisphereJob& job, double more,
                      const std::string& side) {
        const double albedo = more + std::max({job.total[1], job.total[2], job.total[3]});
        const double unsure = *std::max_element(&job.error[1], &job.error[4]);
        const bool claimed = context_.claims(c).conserves_energy;
        if (claimed) report_.largest_albedo = std::max(report_.largest_albedo, albedo - unsure);
        energy_.see(claimed, albedo - 1 - unsure, c.text + side);
    }

    void judge_case(const CheckCase& c, const HemisphereJob& job, const Drawn& drawn) {
        horizon_.see(drawn.outside, c.text);
        judge_energy(c, job, drawn.delta_albedo, "");
        const double albedo = (job.total[1] + job.total[2] + job.total[3]) / 3 + drawn.delta_albedo;
        const double coarse = std::max(job.error[0], albedo > 0 ? job.error[1] / albedo : 0);
        if (!(coarse <= effort().resolution)) {
            ++unresolved_;
            resolved_.where = c.text;
        }
        resolved_.see(0, "");
        if (!(coarse <= effort().resolution)) return;
        if (albedo == 0 && drawn.lost == static_cast<double>(drawn.weights.size())) return;
        judge_density(c, job, drawn);
        judge_weights(c, job, drawn, albedo);
    }

    // A model may only lose the samples it says; what is lost must be what the density lacks.
    void judge_density(const CheckCase& c, const HemisphereJob& job, const Drawn& drawn) {
        const auto count = static_cast<double>(drawn.weights.size());
        const double mass = job.total[0] + drawn.delta_share;
        density_.see(context_.claims(c).keeps_samples,
                     std::max(std::abs(mass - 1) - 2 * job.error[0], drawn.lost / count), c.text);
        std::vector<double> expected(drawn.counts.size());
        for (std::size_t k = 0; k + 1 < expected.size(); ++k)
            expected[k] = std::max(0.0, count * job.by_cell[k][0]);
        expected.back() = count * std::max(0.0, 1 - mass);
        if (expected.back() < 0.01) expected.back() = drawn.counts.back() > 0 ? 0.01 : 0;
        if (drawn.delta_share < 1)
            chi_square_.see_p(lobe::chi_square(drawn.counts, expected, false).p, c.text);
    }

    void judge_weights(const CheckCase& c, const HemisphereJob& job, const Drawn& drawn,
                       double albedo) {
        if (!(albedo > 0)) return;
        // The variance by quadrature, too: samples may have missed what makes it large. Where all
        // weights are equal, rounding is what is left.
        const double by_deltas =
            drawn.delta_share > 0 ? square(drawn.delta_albedo) / drawn.delta_share : 0;
        const double variance = std::max(0.0, job.total[4] + by_deltas - square(albedo));
        const double error =
            std::hypot(std::sqrt(variance / static_cast<double>(drawn.weights.size())),
                       1e-4 * albedo, job.error[1]);
        albedo_.see_p(two_sided_p((mean(drawn.weights) - albedo) / error), c.text);
        if (drawn.delta_share > 0) return;
        const double deviation = std::sqrt(variance) / std::max(albedo, 0.05);
        variance_.see(deviation, c.text);
        report_.largest_weight_deviation = std::max(report_.largest_weight_deviation, deviation);
    }

    CheckContext& context_;
    ModelReport& report_;
    Finding horizon_{"horizon"};
    ClaimTest density_;
    Finding chi_square_{"chi-square"};
    Finding albedo_{"albedo"};
    ClaimTest energy_;
    Finding variance_{"variance"};
    Finding resolved_{"cubature"};
    std::size_t unresolved_ = 0;
};

}  // namespace

std::vector<Finding> check_sampling(CheckContext& context, ModelReport& report) {
    SamplingChecks checks(context, report);
    checks.run();
    return checks.finish();
}

}  // namespace lobe
