// SPDX-License-Identifier: Apache-2.0
// Asks the device how it lays out the shared structs. layout.def is made from their headers:
// LAYOUT_STRUCT(type) gives a size, LAYOUT_MEMBER(type, member) an offset and a size.
#include "shared/frame.h"
#include "shared/types.h"

#define LAYOUT_STRUCT(type) out[i++] = (uint)sizeof(type);
#define LAYOUT_MEMBER(type, member)                                \
    {                                                              \
        type value;                                                \
        out[i++] = (uint)((uchar*)&value.member - (uchar*)&value); \
        out[i++] = (uint)sizeof(value.member);                     \
    }

kernel void layout(global uint* out) {
    uint i = 0;
#include "layout.def"
}
