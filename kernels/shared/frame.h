// SPDX-License-Identifier: Apache-2.0
// What one launch is told: camera, film, samples, counts. The only struct that changes in a render.
#ifndef LOBE_SHARED_FRAME_H
#define LOBE_SHARED_FRAME_H

#include "shared/layout.h"

// Samples of a pixel form LOBE_REPLICATES independent estimates: sample s belongs to replicate
// s % LOBE_REPLICATES and is point s / LOBE_REPLICATES of that replicate's own sequence. Each split
// costs some of Sobol's evenness: relative RMSE of a glossy scene with 1, 2, 4 replicates was 7.4,
// 8.2, 9.2 % at 8 samples, 2.17, 2.28, 2.44 % at 64. Two is the least that gives an error bar.
#define LOBE_REPLICATES 2

// Float sums in the kernel cover aligned blocks of this many sample indices; the host adds blocks.
#define LOBE_BLOCK 8

// The film is cut into square tiles of so many pixels a side. A launch renders a list of them, each
// with its own samples, so that noisy parts can have more.
#define LOBE_TILE 16

// Nodes of the table of each axis of the pixel filter (the inverse of its cumulative distribution,
// see path/camera.h).
#define LOBE_FILTER_NODES 1025

typedef struct LobeFrame {
    // film: full size, the rendered window's corner and size; tiles across the window
    LobeUint film_width, film_height, window_x, window_y;
    LobeUint window_width, window_height, tiles_across;
    // this launch: so many tiles, so many samples of one block in each; two words of seed
    LobeUint tiles;
    LobeUint samples, seed0, seed1;
    LobeUint light_root;  // of the tree over the lights, as LobeLightNode::child
    LobeUint max_depth, triangles, lights;
    LobeUint filter_table;  // 1: the filter is sampled by its table, 0: it is a box
    // camera in render space: a film point (x, y) in pixels looks along corner + x dx + y dy
    float eye_x, eye_y, eye_z, lens_radius;
    float corner_x, corner_y, corner_z, focal_distance;  // distance along the axis, render units
    float dx_x, dx_y, dx_z, pad1;
    float dy_x, dy_y, dy_z, pad2;
    float axis_x, axis_y, axis_z, pad3;  // unit viewing axis
    // pixel filter: half widths in pixels, part of its size from which a lobe is negative (or
    // infinity), and the weight of every sample, integral of |f| over integral of f
    float filter_radius_x, filter_radius_y, filter_negative_x, filter_negative_y;
    float filter_weight, pad4, pad5, pad6;
    // constant environment: radiance
    float environment_r, environment_g, environment_b, pad7;
} LobeFrame;
LOBE_ASSERT_SIZE(LobeFrame, 192);

// One tile of a launch and the first of its samples: a multiple of LOBE_BLOCK.
typedef struct LobeTileJob {
    LobeUint tile, first_sample, pad0, pad1;
} LobeTileJob;
LOBE_ASSERT_SIZE(LobeTileJob, 16);

// One pixel's block: for each replicate the sum of radiance over its samples, and in w how many
// of them saw a light directly (an exact count).
typedef struct LobeBlockSum {
    float r, g, b, emitter;
} LobeBlockSum;
LOBE_ASSERT_SIZE(LobeBlockSum, 16);

#endif
