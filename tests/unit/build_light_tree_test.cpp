// SPDX-License-Identifier: Apache-2.0
// The tree over the lights: every light that shines is in it once, each node bounds what is below.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/gtc/constants.hpp>

#include "base/random.h"
#include "build/light_tree.h"

using namespace lobe;

namespace {

constexpr double pi = glm::pi<double>();

glm::dvec3 direction(Random& random) {
    const double z = random.uniform(-1, 1), turn = random.uniform(0, 2 * pi);
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(turn), r * std::sin(turn), z};
}

// Small flat lights, some that shine everywhere, some far away, some dark.
std::vector<BoundedLight> lights_of(unsigned count, std::uint64_t seed) {
    Random random(seed);
    std::vector<BoundedLight> lights(count);
    for (BoundedLight& l : lights) {
        LightBounds& b = l.bounds;
        b.distant = random.below(10) == 0;
        b.axis = direction(random);
        if (random.below(4) == 0 || b.distant) b.spread = pi;
        b.low = b.distant ? b.axis : random.uniform(0, 1) * direction(random);
        b.high = b.low;
        if (!b.distant) b.high += glm::dvec3(random.log_uniform(1e-6, 0.1));
        b.intensity = random.below(8) ? random.log_uniform(1e-6, 1) : 0;
        l.light = LobeLight{};
        l.light.kind = b.distant ? LOBE_LIGHT_DISTANT : LOBE_LIGHT_TRIANGLE;
    }
    return lights;
}

glm::dvec3 centre(const LobeLightNode& n, unsigned lane) {
    return {n.centre[0][lane], n.centre[1][lane], n.centre[2][lane]};
}

// Whether what the lane says of a child is true of one light below it.
void expect_bounds(const LobeLightNode& n, unsigned lane, const LightBounds& b) {
    EXPECT_EQ(n.near[lane], b.distant ? 0 : 1);
    for (const glm::dvec3& corner : {b.low, b.high, glm::dvec3(b.low.x, b.high.y, b.low.z)})
        EXPECT_LE(glm::length(corner - centre(n, lane)), n.radius[lane]);
    if (n.spread_cosine[lane] == -2) return;  // everywhere
    EXPECT_LT(b.spread, pi);
    const glm::dvec3 axis(n.axis[0][lane], n.axis[1][lane], n.axis[2][lane]);
    const double spread = std::atan2(n.spread_sine[lane], n.spread_cosine[lane]);
    EXPECT_LE(std::acos(std::min(1.0, glm::dot(axis, b.axis))) + b.spread, spread + 1e-3);
}

void expect_sound(const std::vector<BoundedLight>& lights) {
    const LightTree tree = make_light_tree(lights);
    ASSERT_EQ(tree.lights.size(), lights.size());
    std::vector<int> found(lights.size());
    std::vector<int> visited(tree.nodes.size());
    // Every light below a reference, with the intensity that the lanes add up to.
    const std::function<std::vector<std::size_t>(LobeUint, LobeUint)> below = [&](LobeUint child,
                                                                                  LobeUint place) {
        std::vector<std::size_t> all;
        if (child & LOBE_LEAF) {
            const std::size_t light = child & LOBE_LEAF_INDEX;
            EXPECT_EQ(tree.lights[light].place, place);
            ++found[light];
            return std::vector<std::size_t>{light};
        }
        const LobeLightNode& node = tree.nodes[child];
        ++visited[child];
        EXPECT_EQ(node.parent, place);
        for (unsigned lane = 0; lane < LOBE_WIDTH; ++lane) {
            if (node.intensity[lane] == 0) continue;
            const auto under = below(node.child[lane], LOBE_WIDTH * child + lane);
            double sum = 0;
            for (const std::size_t light : under) {
                sum += lights[light].bounds.intensity;
                expect_bounds(node, lane, lights[light].bounds);
            }
            const double far = node.near[lane] ? 1 : std::max(1.0f, node.radius[lane]);
            EXPECT_NEAR(node.intensity[lane], sum * far * far, 1e-5 * sum * far * far);
            all.insert(all.end(), under.begin(), under.end());
        }
        return all;
    };
    below(tree.root, LOBE_NONE);
    for (std::size_t i = 0; i < lights.size(); ++i)
        EXPECT_EQ(found[i], lights[i].bounds.intensity > 0) << "light " << i;
    for (const int visits : visited) EXPECT_EQ(visits, 1);
}

}  // namespace

TEST(BuildLightTree, HoldsEveryLightOnce) {
    for (const unsigned count : {2u, 3u, 8u, 9u, 100u, 2000u})
        expect_sound(lights_of(count, count));
}

TEST(BuildLightTree, LightsInOnePlace) {
    std::vector<BoundedLight> lights = lights_of(100, 5);
    for (BoundedLight& l : lights) {
        l.bounds.low = l.bounds.high = glm::dvec3(0.25);
        l.bounds.distant = false;
    }
    expect_sound(lights);
    for (BoundedLight& l : lights) l.bounds = lights[0].bounds;
    expect_sound(lights);
}

TEST(BuildLightTree, WithoutLightThereIsNoTree) {
    EXPECT_TRUE(make_light_tree({}).lights.empty());
    std::vector<BoundedLight> dark = lights_of(3, 1);
    for (BoundedLight& l : dark) l.bounds.intensity = 0;
    EXPECT_TRUE(make_light_tree(dark).lights.empty());
}

TEST(BuildLightTree, OneLightNeedsNoNode) {
    std::vector<BoundedLight> lights = lights_of(2, 3);
    lights[0].bounds.intensity = 0;
    lights[1].bounds.intensity = 1;
    const LightTree tree = make_light_tree(lights);
    EXPECT_TRUE(tree.nodes.empty());
    EXPECT_EQ(tree.root, LOBE_LEAF | 1);
}

// Both halves of a quadrilateral hang at one place, and share its bounds.
TEST(BuildLightTree, HalvesGoTogether) {
    std::vector<BoundedLight> lights = lights_of(40, 9);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        lights[i].bounds.distant = false;
        lights[i].bounds.intensity = 1;
        lights[i].completes = i % 2 == 1;
    }
    const LightTree tree = make_light_tree(lights);
    for (std::size_t i = 0; i < lights.size(); i += 2) {
        const LobeUint place = tree.lights[i].place;
        EXPECT_EQ(tree.lights[i + 1].place, place);
        EXPECT_TRUE(tree.lights[i].flags & LOBE_LIGHT_FIRST_HALF);
        EXPECT_TRUE(tree.lights[i + 1].flags & LOBE_LIGHT_SECOND_HALF);
        const LobeLightNode& node = tree.nodes[place / LOBE_WIDTH];
        EXPECT_EQ(node.child[place % LOBE_WIDTH], LOBE_LEAF | i);
        EXPECT_EQ(node.intensity[place % LOBE_WIDTH], 2);
        for (const std::size_t half : {i, i + 1})
            expect_bounds(node, place % LOBE_WIDTH, lights[half].bounds);
    }
}

TEST(BuildLightTree, ConesHoldBothCones) {
    Random random(4);
    for (int i = 0; i < 2000; ++i) {
        LightBounds a, b;
        a.axis = direction(random);
        b.axis = i % 5 == 0 ? -a.axis : i % 5 == 1 ? a.axis : direction(random);
        a.spread = i % 3 ? random.uniform(0, pi) : 0;
        b.spread = i % 7 ? random.uniform(0, pi) : 0;
        const LightBounds c = joined(a, b);
        EXPECT_NEAR(glm::length(c.axis), 1, 1e-9);
        for (const LightBounds& part : {a, b}) {
            const double away =
                2 * std::atan2(glm::length(c.axis - part.axis), glm::length(c.axis + part.axis));
            EXPECT_LE(std::min(away + part.spread, pi), c.spread + 1e-7);
        }
    }
}
