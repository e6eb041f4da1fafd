// SPDX-License-Identifier: Apache-2.0
// The header of a PLY file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lobe {

enum class PlyFormat { ascii, little_endian, big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
    std::string name;
    PlyType type;
    bool is_list = false;
    PlyType count_type = PlyType::uint8;  // of a list
};

struct PlyElement {
    std::string name;
    std::uint64_t count;
    std::vector<PlyProperty> properties;

    // Place of the property with one of the names, or -1.
    int find(const std::vector<std::string>& names) const;
};

struct PlyHeader {
    PlyFormat format;
    std::vector<PlyElement> elements;
    std::size_t size;  // bytes, with the end of its last line
};

std::size_t size_of(PlyType type);

// Throws Error (scene) with the line of the header that is wrong.
PlyHeader parse_ply_header(const std::string& path, const std::string& bytes);

}  // namespace lobe
