// SPDX-License-Identifier: Apache-2.0
// What lets one header be read by OpenCL C and by C++: the scalar types and a layout assertion.
//
// Shared structs are rows of 16 bytes made of 32-bit scalars only, so that no compiler, device or
// packing rule can lay them out differently; a test asks the device for its sizes and offsets.
#ifndef LOBE_SHARED_LAYOUT_H
#define LOBE_SHARED_LAYOUT_H

#ifndef __cplusplus
typedef uint LobeUint;
typedef int LobeInt;
#define LOBE_ASSERT_SIZE(type, bytes) \
    typedef char type##_must_have_##bytes##_bytes[sizeof(type) == (bytes) ? 1 : -1]
#else
#include <cstdint>
typedef std::uint32_t LobeUint;
typedef std::int32_t LobeInt;
#define LOBE_ASSERT_SIZE(type, bytes) \
    static_assert(sizeof(type) == (bytes), #type " has " #bytes " bytes")
#endif

#define LOBE_NONE 0xffffffffu  // "no such index": no light, no primitive, no child

#endif
