// SPDX-License-Identifier: Apache-2.0
#include "scene/measured_files.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

#include "base/error.h"
#include "base/files.h"
#include "scene/source.h"

namespace lobe {
namespace {

// W. Matusik et al., "A data-driven reflectance model", 2003: what the numbers of a channel's plane
// are multiplied with.
constexpr double merl_scale[3] = {1.0 / 1500, 1.15 / 1500, 1.66 / 1500};
constexpr std::size_t merl_header = 3 * sizeof(std::int32_t);

constexpr char text_word[] = "brdf";

std::string counts_text(const std::array<std::uint32_t, 3>& n) {
    return std::to_string(n[0]) + " x " + std::to_string(n[1]) + " x " + std::to_string(n[2]);
}

// What is wrong with the counts of a table, or "".
std::string fault_of(const std::array<std::int64_t, 3>& n) {
    std::int64_t cells = 1;
    for (const std::int64_t count : n) {
        if (count < 1 || count > most_cells_along)
            return "the table has " + std::to_string(count) +
                   " cells along an axis; it may have 1 to " + std::to_string(most_cells_along);
        cells *= count;
    }
    if (cells > most_cells)
        return "the table has " + std::to_string(cells) + " cells; it may have " +
               std::to_string(most_cells);
    return "";
}

// What is wrong with a cell's value, or "". A cell with a negative channel has no data.
std::string set_value(glm::vec3& cell, const glm::dvec3& value) {
    for (int k = 0; k < 3; ++k) {
        if (!std::isfinite(value[k])) return "a value is not finite";
        if (value[k] > largest_measured_value)
            return "the value " + show(value[k]) + " is too large";
    }
    const bool measured = value.x >= 0 && value.y >= 0 && value.z >= 0;
    cell = measured ? glm::vec3(value) : glm::vec3(std::numeric_limits<float>::quiet_NaN());
    return "";
}

MeasuredBrdf empty_table(const std::array<std::int64_t, 3>& n) {
    MeasuredBrdf table;
    for (int i = 0; i < 3; ++i) table.counts[i] = static_cast<std::uint32_t>(n[i]);
    table.values.resize(static_cast<std::size_t>(n[0] * n[1] * n[2]));
    return table;
}

MeasuredBrdf read_merl(const std::string& path, const std::string& bytes) {
    std::array<std::int64_t, 3> n;
    for (std::size_t i = 0; i < 3; ++i) {
        std::int32_t count;
        std::memcpy(&count, &bytes[i * sizeof count], sizeof count);
        n[i] = count;
    }
    const std::string fault = fault_of(n);
    if (!fault.empty())
        throw Error(ExitCode::scene, fault, path, "is this a table in MERL's binary layout?");
    const auto cells = static_cast<std::size_t>(n[0] * n[1] * n[2]);
    const std::size_t wanted = merl_header + 3 * cells * sizeof(double);
    if (bytes.size() != wanted)
        throw Error(ExitCode::scene,
                    "a table of " + std::to_string(n[0]) + " x " + std::to_string(n[1]) + " x " +
                        std::to_string(n[2]) + " cells has " + std::to_string(wanted) +
                        " bytes, the file " + std::to_string(bytes.size()),
                    path, bytes.size() < wanted ? "is it all there?" : "");
    MeasuredBrdf table = empty_table(n);
    for (std::size_t cell = 0; cell < cells; ++cell) {
        glm::dvec3 value;
        for (std::size_t k = 0; k < 3; ++k) {
            double number;
            std::memcpy(&number, &bytes[merl_header + (k * cells + cell) * sizeof number],
                        sizeof number);
            value[static_cast<int>(k)] = number * merl_scale[k];
        }
        const std::string wrong = set_value(table.values[cell], value);
        if (!wrong.empty())
            throw Error(ExitCode::scene, wrong + " (cell " + std::to_string(cell) + ")", path);
    }
    return table;
}

// The words of a text table.
class Words {
  public:
    explicit Words(const SourceFile& file) : file_(file) {}

    Place place() const { return {&file_, begin_}; }

    // The next word; empty at the end. A # begins a comment, to the end of its line.
    std::string_view next() {
        const std::string& text = file_.text;
        while (at_ < text.size() && (is_blank(text[at_]) || text[at_] == '#')) {
            if (text[at_] == '#') at_ = std::min(text.find('\n', at_), text.size() - 1);
            ++at_;
        }
        begin_ = at_;
        while (at_ < text.size() && !is_blank(text[at_]) && text[at_] != '#') ++at_;
        return std::string_view(text).substr(begin_, at_ - begin_);
    }

    template <typename Number>
    Number number(const char* what) {
        const std::string_view word = next();
        Number value{};
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (word.empty()) fail(place(), std::string("the file ends where ") + what + " should be");
        if (error != std::errc() || end != word.data() + word.size())
            fail(place(), "'" + std::string(word.substr(0, 40)) + "' is not " + what);
        return value;
    }

  private:
    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

    const SourceFile& file_;
    std::size_t at_ = 0, begin_ = 0;
};

MeasuredBrdf read_text(const std::string& path, std::string bytes) {
    const auto file = make_source(path, std::move(bytes));
    Words words(*file);
    if (words.next() != text_word)
        fail(words.place(), "this is no table of reflectance",
             "a text table begins with \"brdf\" and three counts, a binary one with three counts");
    std::array<std::int64_t, 3> n;
    for (std::int64_t& count : n) {
        count = words.number<std::int64_t>("a count of cells");
        if (count < 1 || count > most_cells_along) fail(words.place(), fault_of({count, 1, 1}));
    }
    const std::string fault = fault_of(n);
    if (!fault.empty()) fail(words.place(), fault);
    // A cell takes six bytes at least: three digits with something between them.
    if (static_cast<std::size_t>(n[0] * n[1] * n[2]) > file->text.size() / 6 + 1)
        fail(words.place(), "the file is too short for the cells that it announces");
    MeasuredBrdf table = empty_table(n);
    for (glm::vec3& cell : table.values) {
        glm::dvec3 value;
        for (int k = 0; k < 3; ++k) value[k] = words.number<double>("a number");
        const std::string wrong = set_value(cell, value);
        if (!wrong.empty()) fail(words.place(), wrong);
    }
    if (!words.next().empty())
        fail(words.place(),
             "there is more after the last of " + counts_text(table.counts) + " cells");
    return table;
}

}  // namespace

MeasuredBrdf read_measured(const std::string& path) {
    std::string bytes = read_file(path, ExitCode::scene);
    if (bytes.compare(0, 11, "tensor_file") == 0)
        throw Error(ExitCode::scene,
                    "tensor files (.bsdf) of adaptively measured reflectance are "
                    "understood but not supported yet",
                    path, "give a table in MERL's binary layout, or as text");
    // The upper byte of a count is 0, and no text has such a byte.
    if (bytes.find('\0') >= merl_header) return read_text(path, std::move(bytes));
    if (bytes.size() < merl_header)
        throw Error(ExitCode::scene, "the file ends within its first three numbers", path);
    return read_merl(path, bytes);
}

void write_merl(const std::string& path, const MeasuredBrdf& table) {
    std::string bytes;
    const auto add = [&bytes](const auto& number) {
        bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    };
    for (const std::uint32_t count : table.counts) add(static_cast<std::int32_t>(count));
    for (int k = 0; k < 3; ++k)
        for (const glm::vec3& value : table.values)
            add(std::isnan(value[k]) ? -1.0 : static_cast<double>(value[k]) / merl_scale[k]);
    write_file(path, bytes);
}

void write_measured_text(const std::string& path, const MeasuredBrdf& table) {
    const auto& n = table.counts;
    std::string text = "# theta_h, theta_d, phi_d; then r g b in 1/sr, phi_d running fastest\n";
    text += std::string(text_word) + " " + std::to_string(n[0]) + " " + std::to_string(n[1]) + " " +
            std::to_string(n[2]) + "\n";
    for (const glm::vec3& value : table.values) {
        char line[80];
        if (std::isnan(value.x))
            std::snprintf(line, sizeof line, "-1 -1 -1\n");
        else
            std::snprintf(line, sizeof line, "%.9g %.9g %.9g\n", static_cast<double>(value.x),
                          static_cast<double>(value.y), static_cast<double>(value.z));
        text += line;
    }
    write_file(path, text);
}

}  // namespace lobe
