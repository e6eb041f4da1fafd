// SPDX-License-Identifier: Apache-2.0
// Integer counters of what became of paths and of the light samples on their way. Every tile of a
// launch has a row of them; sums of integers are the same in whatever order they are made.
#ifndef LOBE_SHARED_STATISTICS_H
#define LOBE_SHARED_STATISTICS_H

// Light samples, by their fate.
#define LOBE_STATISTIC_LIGHT_REACHED 0   // they lit the surface
#define LOBE_STATISTIC_LIGHT_OCCLUDED 1  // something stood in the way
#define LOBE_STATISTIC_LIGHT_USELESS 2   // facing away or reflected as black: no shadow ray needed

// Surface points at which a direction to go on was drawn.
#define LOBE_STATISTIC_DIRECTIONS 3

// Paths, by their end. Their sum is the number of samples.
#define LOBE_STATISTIC_ENDS 4
#define LOBE_STATISTIC_ESCAPED 4    // into the environment or the void
#define LOBE_STATISTIC_LOST 5       // black or hidden by the surface itself (or not a number)
#define LOBE_STATISTIC_ROULETTE 6   // Russian roulette
#define LOBE_STATISTIC_TRUNCATED 7  // at the largest depth

// Paths, by their scattering events: 0, 1, 2, 3, 4, 5 to 8, 9 to 16, 17 and more.
#define LOBE_STATISTIC_DEPTHS 8
#define LOBE_DEPTH_BINS 8

// Throughput of the paths that the largest depth ended: sum of its luminance, at most
// LOBE_MOST_TRUNCATED of a path, in units of 1 / LOBE_TRUNCATED_UNIT. What they would still have
// brought is this times the radiance that their last surface scatters.
#define LOBE_STATISTIC_TRUNCATED_THROUGHPUT 16
#define LOBE_TRUNCATED_UNIT 1024
#define LOBE_MOST_TRUNCATED 512

#define LOBE_STATISTIC_COUNT 17

#endif
