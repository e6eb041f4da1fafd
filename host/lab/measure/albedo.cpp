// SPDX-License-Identifier: Apache-2.0
#include "lab/measure/albedo.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "base/random.h"

namespace lobe {
namespace {

// Where the integrand may matter: where the model sends samples, and evenly.
std::vector<PilotPoint> pilot_points(const BrdfSampled* samples, std::size_t count,
                                     double towards) {
    std::vector<PilotPoint> points;
    for (std::size_t k = 0; k < count; ++k)
        if (!samples[k].delta && samples[k].pdf > 0 && samples[k].wi.z > 0)
            points.push_back({elevation_azimuth(samples[k].wi, towards), samples[k].pdf});
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 16; ++j)
            points.push_back({(i + 0.5) / 8 * glm::half_pi<double>(),
                              ((j + 0.5) / 8 - 1) * glm::pi<double>(), 0});
    return points;
}

glm::dvec3 delta_albedo(const BrdfSampled* samples, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k)
        if (samples[k].delta) return samples[k].weight * samples[k].pdf;
    return glm::dvec3(0);
}

std::vector<BrdfSampled> draw(const BrdfProbe& probe, const std::vector<AlbedoCase>& cases,
                              std::size_t count) {
    BrdfQuery numbers;
    Random random(5);
    for (const AlbedoCase& c : cases)
        for (std::size_t k = 0; k < count; ++k)
            numbers.add(c.set, c.wo,
                        {random.uniform_float(), random.uniform_float(), random.uniform_float()});
    return probe.sample(numbers);
}

}  // namespace

std::vector<Albedo> directional_albedos(const BrdfProbe& probe,
                                        const std::vector<AlbedoCase>& cases,
                                        const AlbedoEffort& effort) {
    const std::vector<BrdfSampled> samples = draw(probe, cases, effort.pilot);
    std::vector<HemisphereJob> jobs(cases.size());
    for (std::size_t i = 0; i < cases.size(); ++i) {
        jobs[i].number = static_cast<std::uint32_t>(i);
        jobs[i].towards = std::atan2(-cases[i].wo.y, -cases[i].wo.x);
        const HemisphereCells grid(
            pilot_points(&samples[i * effort.pilot], effort.pilot, jobs[i].towards), effort.cells);
        jobs[i].patches = grid.patches();
        jobs[i].pilot = grid.pilot();
    }
    const auto values_at = [&](const HemisphereNodes& nodes) {
        BrdfQuery query;
        for (std::size_t k = 0; k < nodes.jobs.size(); ++k)
            query.add(cases[nodes.jobs[k]].set, cases[nodes.jobs[k]].wo, nodes.directions[k]);
        std::vector<HemisphereJob::Values> values;
        for (const BrdfValue& v : probe.eval(query))
            values.push_back({v.pdf, v.f.x, v.f.y, v.f.z, 0});
        return values;
    };
    integrate(jobs, values_at, effort.cubature);
    std::vector<Albedo> albedos;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const HemisphereJob& job = jobs[i];
        const glm::dvec3 smooth(job.total[1], job.total[2], job.total[3]);
        const glm::dvec3 mirror = delta_albedo(&samples[i * effort.pilot], effort.pilot);
        albedos.push_back(
            {smooth + mirror, mirror, std::max({job.error[1], job.error[2], job.error[3]})});
    }
    return albedos;
}

}  // namespace lobe
