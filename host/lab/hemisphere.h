// SPDX-License-Identifier: Apache-2.0
// Integrals over the hemisphere of functions that only the device can evaluate, many at a time.
//
// Coordinates are the elevation above the horizon and the azimuth: what is smooth on the sphere is
// smooth in them, also at the normal; the horizon is a border; and cosines near 0 keep their
// digits. Narrow lobes are found by a pilot: points where the integrand is known to matter.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace lobe {

// The direction of an elevation and an azimuth, in radians.
glm::dvec3 direction_at(double elevation, double azimuth);
// Elevation and azimuth (from `towards`, in [-pi, pi]) of a direction.
glm::dvec2 elevation_azimuth(const glm::dvec3& direction, double towards);

// A place where the integrand is known: elevation, azimuth, and its first value there (0: unknown).
using PilotPoint = glm::dvec3;

// A rectangle of elevations [low.x, high.x] and azimuths [low.y, high.y].
struct Patch {
    glm::dvec2 low, high;
    std::uint32_t cell;
    std::uint32_t first, count;  // its part of the pilot
};

// The hemisphere cut into cells that each hold about `pilot / cells` of the pilot's points.
class HemisphereCells {
  public:
    HemisphereCells(std::vector<PilotPoint> pilot, std::size_t cells);
    std::size_t count() const { return patches_.size(); }
    std::size_t cell_of(const glm::dvec2& point) const;
    const std::vector<Patch>& patches() const { return patches_; }  // one a cell
    const std::vector<PilotPoint>& pilot() const { return pilot_; }

  private:
    struct Node {
        int axis;       // 0, 1, or -1 for a cell
        double border;  // below it: the left child
        std::uint32_t left, right;
    };
    std::uint32_t build(const Patch& patch, std::size_t most);

    std::vector<PilotPoint> pilot_;
    std::vector<Node> nodes_;
    std::vector<Patch> patches_;
};

// One integral: where it is taken, and what is found.
struct HemisphereJob {
    std::uint32_t number;           // handed to the integrand
    double towards;                 // azimuth 0 of the patches
    std::vector<Patch> patches;     // cover the hemisphere once, a cell each
    std::vector<PilotPoint> pilot;  // in the order of the patches

    static constexpr int values = 5;
    using Values = std::array<double, values>;
    std::vector<Values> by_cell;  // integrals over each cell
    Values total{}, error{};      // over the hemisphere, and how far off that may be
    std::size_t nodes = 0;        // evaluations
};

// Directions to evaluate, each for a job; gives HemisphereJob::values numbers each.
struct HemisphereNodes {
    std::vector<std::uint32_t> jobs;  // HemisphereJob::number
    std::vector<glm::dvec3> directions;
};
using HemisphereIntegrand =
    std::function<std::vector<HemisphereJob::Values>(const HemisphereNodes&)>;

struct CubatureOptions {
    double relative = 2e-5;            // of a job's largest total
    int rounds = 40;                   // of splitting
    std::size_t nodes_a_job = 300000;  // give up beyond
};

// Adaptive cubature in solid angle of all jobs at once: every round evaluates the split patches of
// all jobs in one call. A rule of 7 x 7 nodes over one of 4 x 4 tells which patches to split; and
// so does the pilot, where it has seen a peak in a patch that the nodes have not.
void integrate(std::vector<HemisphereJob>& jobs, const HemisphereIntegrand& integrand,
               const CubatureOptions& options = {});

}  // namespace lobe
