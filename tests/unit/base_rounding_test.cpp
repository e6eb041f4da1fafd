// SPDX-License-Identifier: Apache-2.0
// That the compiler rounds where the source does: much of what is reckoned against the device's
// floats goes by way of one and back. GCC 12.2 at -O2 does not, unless its vectoriser is held.
#include <gtest/gtest.h>

#include <glm/glm.hpp>

namespace {

[[gnu::noinline]] glm::dvec3 as_floats(const glm::dvec3& v) { return glm::dvec3(glm::vec3(v)); }

}  // namespace

TEST(BaseRounding, DoublesBecomeFloatsOnTheWay) {
    volatile double third = 1.0 / 3;
    const glm::dvec3 v(third, 2 * third, 5 * third), rounded = as_floats(v);
    for (int k = 0; k < 3; ++k) {
        EXPECT_NE(rounded[k], v[k]) << k;
        volatile float one = static_cast<float>(v[k]);
        EXPECT_EQ(rounded[k], static_cast<double>(one)) << k;
    }
}
