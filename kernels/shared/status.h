// SPDX-License-Identifier: Apache-2.0
// Integer counters that kernels raise when a sample is not what it must be. They are zero in a
// sound render; the host reports each that is not.
#ifndef LOBE_SHARED_STATUS_H
#define LOBE_SHARED_STATUS_H

#define LOBE_STATUS_NONFINITE 0  // radiance of a sample is NaN or infinite: the sample counts as 0
#define LOBE_STATUS_NEGATIVE 1   // radiance of a sample is negative before the filter weight
#define LOBE_STATUS_TRAP 2       // a material's model is compiled out
#define LOBE_STATUS_PIXEL 3      // pixel + 1 of the first such sample
#define LOBE_STATUS_SAMPLE 4     // and its sample index
#define LOBE_STATUS_COUNT 8

#endif
