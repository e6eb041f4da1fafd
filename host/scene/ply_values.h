// SPDX-License-Identifier: Apache-2.0
// The numbers of a PLY file's body, one after the other, of any format.
#pragma once

#include <string>

#include "scene/ply_header.h"

namespace lobe {

class PlyValues {
  public:
    // Of `bytes` from the end of the header on.
    PlyValues(const std::string& path, const std::string& bytes, const PlyHeader& header)
        : path_(path), bytes_(bytes), format_(header.format), at_(header.size), last_(at_) {}

    // The next number. Throws Error (scene) at the file's end and for what is no number.
    double next(PlyType type) {
        return format_ == PlyFormat::ascii ? next_ascii() : next_binary(type);
    }

    // A length: a whole number from 0 on that the rest of the file has room for.
    std::size_t next_length(const PlyProperty& list);

    // Fails if the rest of the file is too short for all of an element's rows.
    void check_room(const PlyElement& element) const;

    // Throws Error (scene) at the number read last.
    [[noreturn]] void fail(const std::string& what) const;

  private:
    double next_ascii();
    double next_binary(PlyType type);
    std::size_t remaining() const { return bytes_.size() - at_; }
    // Fewest bytes of a value.
    std::size_t least(PlyType type) const {
        return format_ == PlyFormat::ascii ? 2 : size_of(type);
    }

    const std::string& path_;
    const std::string& bytes_;
    PlyFormat format_;
    std::size_t at_, last_;
};

}  // namespace lobe
