// SPDX-License-Identifier: Apache-2.0
#include "scene/ply_header.h"

#include <charconv>
#include <map>

#include "base/error.h"
#include "scene/source.h"

namespace lobe {

namespace {

const std::map<std::string, PlyType> types{
    {"char", PlyType::int8},       {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},     {"short", PlyType::int16},     {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},   {"uint16", PlyType::uint16},   {"int", PlyType::int32},
    {"int32", PlyType::int32},     {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
    {"float", PlyType::float32},   {"float32", PlyType::float32}, {"double", PlyType::float64},
    {"float64", PlyType::float64},
};

// Reads the header line by line.
class HeaderReader {
  public:
    HeaderReader(const std::string& path, const std::string& bytes) : path_(path), bytes_(bytes) {}

    PlyHeader read() {
        if (!next_line() || words_ != std::vector<std::string>{"ply"})
            error("not a PLY file: it does not begin with 'ply'");
        if (!next_line() || words_.size() != 3 || words_[0] != "format") error("no format line");
        read_format();
        while (next_line()) {
            if (words_.empty() || words_[0] == "comment" || words_[0] == "obj_info") continue;
            if (words_[0] == "end_header") {
                header_.size = at_;
                return std::move(header_);
            }
            if (words_[0] == "element") {
                read_element();
            } else if (words_[0] == "property") {
                read_property();
            } else {
                error("unknown header word '" + words_[0] + "'");
            }
        }
        error("the header does not end");
    }

  private:
    [[noreturn]] void error(const std::string& what) const {
        throw Error(ExitCode::scene, what, path_ + ":" + std::to_string(line_) + ":1");
    }

    bool next_line() {
        ++line_;
        const std::size_t end = bytes_.find('\n', at_);
        words_.clear();
        if (end == std::string::npos) return false;
        const std::string blanks = " \t\r";
        std::size_t begin = bytes_.find_first_not_of(blanks, at_);
        while (begin < end) {
            const std::size_t stop = std::min(bytes_.find_first_of(blanks, begin), end);
            words_.push_back(bytes_.substr(begin, stop - begin));
            begin = bytes_.find_first_not_of(blanks, stop);
        }
        at_ = end + 1;
        return true;
    }

    void read_format() {
        const std::string& format = words_[1];
        if (format == "ascii") {
            header_.format = PlyFormat::ascii;
        } else if (format == "binary_little_endian") {
            header_.format = PlyFormat::little_endian;
        } else if (format == "binary_big_endian") {
            header_.format = PlyFormat::big_endian;
        } else {
            error("unknown format '" + format + "'");
        }
        if (words_[2] != "1.0") error("unknown format version '" + words_[2] + "'");
    }

    void read_element() {
        if (words_.size() != 3) error("an element wants a name and a count");
        const std::string& count = words_[2];
        PlyElement element{words_[1], 0, {}};
        const auto [end, fault] =
            std::from_chars(count.data(), count.data() + count.size(), element.count);
        if (fault != std::errc() || end != count.data() + count.size())
            error("an element wants a count, has '" + count + "'");
        if (element.count > 0xffffffffu) error("too many elements (" + count + ")");
        header_.elements.push_back(std::move(element));
    }

    PlyType type(const std::string& word) const {
        const auto found = types.find(word);
        if (found == types.end()) error("unknown property type '" + word + "'");
        return found->second;
    }

    void read_property() {
        if (header_.elements.empty()) error("a property before the first element");
        const bool is_list = words_.size() == 5 && words_[1] == "list";
        if (!is_list && words_.size() != 3) error("a property wants a type and a name");
        PlyProperty property;
        property.is_list = is_list;
        property.name = words_.back();
        property.type = type(words_[words_.size() - 2]);
        if (is_list) property.count_type = type(words_[2]);
        header_.elements.back().properties.push_back(property);
    }

    const std::string& path_;
    const std::string& bytes_;
    std::size_t at_ = 0, line_ = 0;
    std::vector<std::string> words_;
    PlyHeader header_{};
};

}  // namespace

int PlyElement::find(const std::vector<std::string>& names) const {
    for (const std::string& name : names)
        for (std::size_t i = 0; i < properties.size(); ++i)
            if (properties[i].name == name) return static_cast<int>(i);
    return -1;
}

std::size_t size_of(PlyType type) {
    switch (type) {
        case PlyType::int8:
        case PlyType::uint8:
            return 1;
        case PlyType::int16:
        case PlyType::uint16:
            return 2;
        case PlyType::float64:
            return 8;
        default:
            return 4;
    }
}

PlyHeader parse_ply_header(const std::string& path, const std::string& bytes) {
    return HeaderReader(path, bytes).read();
}

}  // namespace lobe
