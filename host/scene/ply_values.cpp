// SPDX-License-Identifier: Apache-2.0
#include "scene/ply_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include "base/error.h"
#include "scene/source.h"

namespace lobe {

namespace {

template <typename T>
double decode(const char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
}

double decode(PlyType type, const char* bytes) {
    switch (type) {
        case PlyType::int8:
            return decode<std::int8_t>(bytes);
        case PlyType::uint8:
            return decode<std::uint8_t>(bytes);
        case PlyType::int16:
            return decode<std::int16_t>(bytes);
        case PlyType::uint16:
            return decode<std::uint16_t>(bytes);
        case PlyType::int32:
            return decode<std::int32_t>(bytes);
        case PlyType::uint32:
            return decode<std::uint32_t>(bytes);
        case PlyType::float32:
            return decode<float>(bytes);
        case PlyType::float64:
            return decode<double>(bytes);
    }
    return 0;
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

}  // namespace

void PlyValues::fail(const std::string& what) const {
    if (format_ != PlyFormat::ascii)
        throw Error(ExitCode::scene, what + " (byte " + std::to_string(last_) + ")", path_);
    const auto begin = bytes_.begin(), here = begin + static_cast<std::ptrdiff_t>(last_);
    const auto line = std::count(begin, here, '\n') + 1;
    const std::size_t newline = last_ == 0 ? std::string::npos : bytes_.rfind('\n', last_ - 1);
    const std::size_t column = newline == std::string::npos ? last_ + 1 : last_ - newline;
    throw Error(ExitCode::scene, what,
                path_ + ":" + std::to_string(line) + ":" + std::to_string(column));
}

double PlyValues::next_ascii() {
    while (at_ < bytes_.size() && is_blank(bytes_[at_])) ++at_;
    last_ = at_;
    const char* const begin = bytes_.data() + at_;
    const char* const end = bytes_.data() + bytes_.size();
    if (begin == end) fail("the file ends too early");
    double value = 0;
    const auto [stop, fault] = std::from_chars(begin + (*begin == '+'), end, value);
    const bool is_word = stop == end || is_blank(*stop);
    if ((fault != std::errc() && fault != std::errc::result_out_of_range) || !is_word) {
        const char* word_end = std::find_if(begin, end, is_blank);
        fail("'" + std::string(begin, std::min(word_end, begin + 40)) + "' is not a number");
    }
    at_ = static_cast<std::size_t>(stop - bytes_.data());
    return fault == std::errc() ? value : std::strtod(std::string(begin, stop).c_str(), nullptr);
}

double PlyValues::next_binary(PlyType type) {
    const std::size_t size = size_of(type);
    last_ = at_;
    if (remaining() < size) fail("the file ends too early");
    char bytes[8];
    std::memcpy(bytes, bytes_.data() + at_, size);
    if (format_ == PlyFormat::big_endian) std::reverse(bytes, bytes + size);
    at_ += size;
    return decode(type, bytes);
}

std::size_t PlyValues::next_length(const PlyProperty& list) {
    const double length = next(list.count_type);
    if (!(length >= 0 && length == std::floor(length) && length <= 4294967295.0))
        fail("a list cannot have " + show(length) + " items");
    const auto items = static_cast<std::size_t>(length);
    if (items * least(list.type) > remaining() + 1)
        fail("the file is too short for a list of " + std::to_string(items) + " items");
    return items;
}

void PlyValues::check_room(const PlyElement& element) const {
    std::uint64_t row = 0;
    for (const PlyProperty& property : element.properties)
        row += least(property.is_list ? property.count_type : property.type);
    if (element.count == 0) return;
    if (row == 0) fail("element '" + element.name + "' has no properties");
    if (element.count > (remaining() + 1) / row)
        fail("the file is too short for " + std::to_string(element.count) + " rows of element '" +
             element.name + "'");
}

}  // namespace lobe
