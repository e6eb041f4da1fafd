// SPDX-License-Identifier: Apache-2.0
// Counting what becomes of paths, cheaply enough to be always on: a work-item counts in private,
// and adds to its tile's row when its samples are done.
#ifndef LOBE_PATH_STATISTICS_H
#define LOBE_PATH_STATISTICS_H

#include "core/vec.h"
#include "shared/frame.h"
#include "shared/statistics.h"

// Of the at most LOBE_BLOCK samples of a work-item.
typedef struct {
    uint light_reached, light_occluded, light_useless, directions, truncated_throughput;
    uint ends;    // four bits for each way to end
    uint depths;  // four bits for each bin of depth
} PathCounts;

typedef char lobe_path_counts_fit[LOBE_BLOCK < 16 ? 1 : -1];

PathCounts no_counts(void) {
    PathCounts counts = {0, 0, 0, 0, 0, 0, 0};
    return counts;
}

// The path ended after `depth` scattering events, `end` being one of the counters of ends.
void count_end(PathCounts* counts, uint end, uint depth) {
    counts->ends += 1u << (4 * (end - LOBE_STATISTIC_ENDS));
    counts->depths += 1u << (4 * (depth < 5 ? depth : depth <= 8 ? 5u : depth <= 16 ? 6u : 7u));
}

// The path ended at the largest depth.
void count_truncated(PathCounts* counts, real3 throughput, uint depth) {
    count_end(counts, LOBE_STATISTIC_TRUNCATED, depth);
    real luminance = dot(throughput, (real3)(R(0.2126), R(0.7152), R(0.0722)));
    counts->truncated_throughput +=
        (uint)(LOBE_TRUNCATED_UNIT * clamp(luminance, R(0.0), R(1.0) * LOBE_MOST_TRUNCATED));
}

// Counters that are 0 cost no access.
void add_count(global uint* counter, uint count) {
    if (count) atomic_add(counter, count);
}

// Adds to the row of LOBE_STATISTIC_COUNT counters of a tile.
void add_counts(global uint* row, const PathCounts* counts) {
    add_count(row + LOBE_STATISTIC_LIGHT_REACHED, counts->light_reached);
    add_count(row + LOBE_STATISTIC_LIGHT_OCCLUDED, counts->light_occluded);
    add_count(row + LOBE_STATISTIC_LIGHT_USELESS, counts->light_useless);
    add_count(row + LOBE_STATISTIC_DIRECTIONS, counts->directions);
    add_count(row + LOBE_STATISTIC_TRUNCATED_THROUGHPUT, counts->truncated_throughput);
    for (uint i = 0; i < 4; ++i)
        add_count(row + LOBE_STATISTIC_ENDS + i, (counts->ends >> (4 * i)) & 15);
    for (uint i = 0; i < LOBE_DEPTH_BINS; ++i)
        add_count(row + LOBE_STATISTIC_DEPTHS + i, (counts->depths >> (4 * i)) & 15);
}

#endif
