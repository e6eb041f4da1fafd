// SPDX-License-Identifier: Apache-2.0
// Eight rays together meet what each meets alone, to the bit.
#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/trace_rig.h"

using namespace lobe;
using namespace lobe::test;

namespace {

// Eights of rays from about one point into about one direction; every fourth eight runs anyhow.
std::vector<TestRay> eights(Random& random, unsigned count, double spread) {
    std::vector<TestRay> rays;
    for (unsigned k = 0; k < count; ++k) {
        const glm::dvec3 origin = 2.0 * random_point(random);
        const glm::dvec3 aim = glm::normalize(random_point(random) - origin);
        const double by = k % 4 == 3 ? 2 : k % 4 == 2 ? 0 : spread;
        for (int i = 0; i < 8; ++i)
            rays.push_back({origin + 0.1 * by * random_point(random),
                            glm::normalize(aim + by * random_point(random))});
    }
    return rays;
}

void expect_same(const TraceRig& rig, const Program& program, Random& random, double spread) {
    const auto rays = eights(random, 4000, spread);
    const auto alone = rig.nearest(program, rays);
    const auto together = rig.nearest(program, rays, Traversal::together);
    const std::size_t triangles = rig.packed().triangles.size();
    unsigned other = 0, met = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        met += alone[i].primitive != LOBE_NONE;
        other += !together[i].same(alone[i], triangles);
    }
    EXPECT_GT(met, 1000u);
    EXPECT_EQ(other, 0u) << "spread " << spread;
}

}  // namespace

TEST(GeomPacket, MeetsWhatSingleRaysMeet) {
    Random random(1);
    std::vector<Sphere> balls;
    for (int i = 0; i < 60; ++i) balls.push_back({random_point(random), 0.15 * random.uniform()});
    const TraceRig soup(triangle_soup(random, 3000), balls);
    const TraceRig torus(bumpy_torus(200, 80));
    for (const char* header : {"", "#define LOBE_PORTABLE_LANES\n"}) {
        const Program program = build_trace_probe(header);
        for (const double spread : {1e-3, 3e-2, 0.3}) {
            expect_same(soup, program, random, spread);
            expect_same(torus, program, random, spread);
        }
    }
}

// Along the axes inverses are huge and zeros have signs.
TEST(GeomPacket, RaysAlongAxes) {
    Random random(2);
    const TraceRig rig(bumpy_torus(60, 30));
    const Program program = build_trace_probe();
    std::vector<TestRay> rays;
    for (int k = 0; k < 600; ++k) {
        glm::vec3 way(0);
        way[k % 3] = k % 2 ? 1 : -1;
        const glm::dvec3 from = -2.0 * glm::dvec3(way) + 0.6 * random_point(random);
        for (int i = 0; i < 8; ++i) {
            glm::vec3 own = way;
            own[(k + 1) % 3] = i % 2 ? 0.0f : -0.0f;
            rays.push_back({from + 0.01 * random_point(random), own});
        }
    }
    const auto alone = rig.nearest(program, rays);
    const auto together = rig.nearest(program, rays, Traversal::together);
    for (std::size_t i = 0; i < rays.size(); ++i) ASSERT_EQ(alone[i], together[i]) << i;
}
