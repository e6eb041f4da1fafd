// SPDX-License-Identifier: Apache-2.0
#include "app/numbers.h"

#include <charconv>
#include <cstdio>

namespace lobe {
namespace {

template <typename Number>
bool parse(const std::string& text, Number& value) {
    const char* end = text.data() + text.size();
    const auto [next, error] = std::from_chars(text.data(), end, value);
    return error == std::errc() && next == end;
}

}  // namespace

CLI::Validator whole_number(std::uint64_t low, std::uint64_t high) {
    const auto check = [low, high](std::string& text) -> std::string {
        std::uint64_t value = 0;
        if (!parse(text, value) || value < low || value > high)
            return "'" + text + "' is no whole number from " + std::to_string(low) + " to " +
                   std::to_string(high);
        text = std::to_string(value);  // CLI11 would read 010 as 8
        return "";
    };
    return CLI::Validator(check, "");
}

CLI::Validator real_number(double low, double high, const std::string& wanted) {
    const auto check = [low, high, wanted](std::string& text) -> std::string {
        double value = 0;
        if (parse(text, value) && value >= low && value <= high) return "";
        return "'" + text + "' is no number " + wanted;
    };
    return CLI::Validator(check, "");
}

CLI::Validator part_of_one() {
    const auto check = [](std::string& text) -> std::string {
        const bool percent = !text.empty() && text.back() == '%';
        double value = 0;
        if (!parse(text.substr(0, text.size() - percent), value) ||
            !(value > 0 && value <= (percent ? 100 : 1)))
            return "'" + text + "' is no part of 1: write 1% or 0.01";
        if (!percent) return "";
        char plain[40];
        std::snprintf(plain, sizeof plain, "%.17g", value / 100);
        text = plain;
        return "";
    };
    return CLI::Validator(check, "");
}

}  // namespace lobe
