// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "build/filter.h"
#include "build/pack.h"
#include "shared/frame.h"

using namespace lobe;

namespace {

const float* nodes_of(const FilterTable& table, int axis) {
    return table.nodes.data() + axis * LOBE_FILTER_NODES;
}

}  // namespace

TEST(BuildFilter, ValuesAreTheFilters) {
    const Filter triangle{FilterKind::triangle, 2, 2};
    EXPECT_EQ(filter_value(triangle, 2, 0), 2);
    EXPECT_EQ(filter_value(triangle, 2, -1.5), 0.5);
    EXPECT_EQ(filter_value(triangle, 2, 2.1), 0);
    const Filter gaussian{FilterKind::gaussian, 2, 2, 2};
    EXPECT_DOUBLE_EQ(filter_value(gaussian, 2, 1), std::exp(-2.0) - std::exp(-8.0));
    EXPECT_EQ(filter_value(gaussian, 2, 2), 0);
    // Mitchell and Netravali's own figure: at 0 (6 - 2 B) / 6, at half the radius B / 6, then 0.
    const Filter mitchell{FilterKind::mitchell, 2, 2, 2, 1.0 / 3, 1.0 / 3};
    EXPECT_NEAR(filter_value(mitchell, 2, 0), 8.0 / 9, 1e-15);
    EXPECT_NEAR(filter_value(mitchell, 2, 1), 1.0 / 18, 1e-15);
    EXPECT_NEAR(filter_value(mitchell, 2, 2), 0, 1e-15);
    EXPECT_LT(filter_value(mitchell, 2, 1.5), 0);
    EXPECT_EQ(filter_value(mitchell, 2, 0.7), filter_value(mitchell, 2, -0.7));
}

TEST(BuildFilter, TablesRunFromTheEdgeToTheMiddle) {
    for (const FilterKind kind :
         {FilterKind::box, FilterKind::triangle, FilterKind::gaussian, FilterKind::mitchell}) {
        const FilterTable table = tabulate_filter({kind, 2, 3});
        ASSERT_EQ(table.nodes.size(), 2u * LOBE_FILTER_NODES);
        for (int axis = 0; axis < 2; ++axis) {
            const float* node = nodes_of(table, axis);
            EXPECT_EQ(node[0], 1);
            EXPECT_EQ(node[LOBE_FILTER_NODES - 1], 0);
            for (int i = 1; i < LOBE_FILTER_NODES; ++i) ASSERT_LE(node[i], node[i - 1]);
        }
    }
}

// Box and triangle have inverses in closed form.
TEST(BuildFilter, KnownInverses) {
    const FilterTable box = tabulate_filter({FilterKind::box, 2, 3});
    const FilterTable triangle = tabulate_filter({FilterKind::triangle, 2, 3});
    for (int i = 0; i < LOBE_FILTER_NODES; ++i) {
        const double v = double(i) / (LOBE_FILTER_NODES - 1);
        ASSERT_NEAR(nodes_of(box, 0)[i], 1 - v * v, 1e-7);
        ASSERT_NEAR(nodes_of(triangle, 1)[i], 1 - v, 2e-5);
    }
}

// For B = C = 1/3 the integral is that of |f| less twice the lobes'.
TEST(BuildFilter, WeightsAndNegativeParts) {
    for (const FilterKind kind : {FilterKind::box, FilterKind::triangle, FilterKind::gaussian}) {
        const FilterTable table = tabulate_filter({kind, 2, 3});
        EXPECT_DOUBLE_EQ(table.weight, 1);
        EXPECT_TRUE(std::isinf(table.negative_x) && std::isinf(table.negative_y));
    }
    const FilterTable table = tabulate_filter({FilterKind::mitchell, 2, 3});
    EXPECT_DOUBLE_EQ(table.negative_x, table.negative_y);  // a matter of shape, not of size
    EXPECT_GT(table.negative_x, 0.9);
    EXPECT_LT(table.negative_x, 1);
    // signed / absolute = 2 negative - 1 along each axis
    EXPECT_NEAR(table.weight, std::pow(2 * table.negative_x - 1, -2), 1e-12);
}

TEST(BuildFilter, FramesOfBoxesTakeNoTable) {
    Scene scene;
    EXPECT_EQ(pack_scene(scene).frame.filter_table, 0u);
    EXPECT_TRUE(pack_scene(scene).filter_nodes.empty());
    scene.filter.kind = FilterKind::triangle;
    EXPECT_EQ(pack_scene(scene).frame.filter_table, 1u);
    EXPECT_EQ(pack_scene(scene).filter_nodes.size(), 2u * LOBE_FILTER_NODES);
}

TEST(BuildFilter, WhatCannotBeSampledIsRefused) {
    // So flat, or so narrow, that its value less its value at the edge is 0 everywhere.
    EXPECT_THROW(tabulate_filter({FilterKind::gaussian, 2, 2, 1e-18}), Error);
    EXPECT_THROW(tabulate_filter({FilterKind::gaussian, 2, 2, 1e13}), Error);
    // Negative, then positive again; and negative in the middle.
    EXPECT_THROW(tabulate_filter({FilterKind::mitchell, 2, 2, 2, 0, -1}), Error);
    EXPECT_THROW(tabulate_filter({FilterKind::mitchell, 2, 2, 2, 4, 0}), Error);
    EXPECT_NO_THROW(tabulate_filter({FilterKind::mitchell, 2, 2, 2, 0, 1}));
}
