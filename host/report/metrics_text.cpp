// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
#include <functional>

#include "base/format.h"
#include "report/metrics_report.h"
#include "report/text_table.h"

namespace lobe {
namespace {

std::string number(double value) { return formatted("%.4g", value); }
std::string number(const std::optional<double>& value) {
    return value ? number(*value) : "unknown";
}
std::string with_share(double value, double share) {
    return formatted("%.4g (%.0f %%)", value, 100 * share);
}

using Cell = std::function<std::string(const ChannelMetrics&)>;

std::string table_text(const PictureMetrics& m, const std::string& a, const std::string& b) {
    using M = const ChannelMetrics&;
    const std::vector<std::pair<std::string, Cell>> rows = {
        {"mean of " + a, [](M c) { return number(c.picture_mean); }},
        {"mean of " + b, [](M c) { return number(c.reference_mean); }},
        {"mean difference", [](M c) { return number(c.mean_difference); }},
        {"RMSE", [](M c) { return number(c.rmse); }},
        {"RMSE / mean", [](M c) { return formatted("%.4g %%", 100 * c.relative_rmse); }},
        {"MSE", [](M c) { return number(c.mse_raw); }},
        {"MSE less variance of " + b, [](M c) { return number(c.mse); }},
        {"MSE trimmed (dropped share)",
         [](M c) { return with_share(c.mse_trimmed, c.mse_trimmed_share); }},
        {"bias squared", [](M c) { return number(c.bias_squared); }},
        {"  its standard error", [](M c) { return number(c.bias_squared_standard_error); }},
        {"relMSE", [](M c) { return number(c.relmse_raw); }},
        {"  its epsilon", [](M c) { return number(c.relmse_epsilon); }},
        {"relMSE less variance of " + b, [](M c) { return number(c.relmse); }},
        {"relMSE trimmed (dropped share)",
         [](M c) { return with_share(c.relmse_trimmed, c.relmse_trimmed_share); }},
        {"SMAPE", [](M c) { return number(c.smape); }},
        {"mean |difference|", [](M c) { return number(c.mean_absolute_error); }},
        {"median", [](M c) { return number(c.median); }},
        {"95 %", [](M c) { return number(c.p95); }},
        {"99 %", [](M c) { return number(c.p99); }},
        {"largest", [](M c) { return number(c.max); }},
        {"  at pixel", [](M c) { return formatted("%u,%u", c.max_x, c.max_y); }},
        {formatted("RMSE of %ux%u blocks", m.block, m.block),
         [](M c) { return number(c.block_rmse); }},
        {"  worst block from",
         [](M c) { return formatted("%u,%u", c.worst_block.x, c.worst_block.y); }},
        {"  its difference", [](M c) { return number(c.worst_block.difference); }}};
    std::vector<std::string> head = {""};
    for (const ChannelMetrics& c : m.channels) head.push_back(c.name);
    TextTable table(head);
    for (const auto& [name, cell] : rows) {
        std::vector<std::string> row = {name};
        for (const ChannelMetrics& c : m.channels) row.push_back(cell(c));
        const auto known = [](const std::string& text) { return text != "unknown"; };
        if (std::any_of(row.begin() + 1, row.end(), known)) table.add(row);
    }
    return table.text();
}

std::string tests_text(const PictureMetrics& m) {
    TextTable table({"", "image t", "p", "worst block", "t", "freedom", "p of all blocks",
                     "chi-square / blocks", "p"});
    for (const ChannelMetrics& c : m.channels) {
        const MeanTest& t = *c.test;
        const Deviation& worst = t.worst.deviation;
        table.add({c.name, formatted("%.2f", t.image.t), formatted("%.3g", t.image.p),
                   formatted("%u,%u", t.worst.block.x, t.worst.block.y), formatted("%.2f", worst.t),
                   formatted("%.1f", worst.freedom), formatted("%.3g", t.blocks_p),
                   formatted("%.4g / %zu", t.chi_square, t.blocks),
                   formatted("%.3g", t.chi_square_p)});
    }
    return table.text();
}

std::string odd_text(const OddValues& odd, const std::string& a, const std::string& b) {
    std::string text;
    if (odd.pixels)
        text += formatted("not finite: %zu NaN and %zu infinite values in %s, ", odd.nan_picture,
                          odd.inf_picture, a.c_str()) +
                formatted("%zu and %zu in %s, %zu bad standard errors; ", odd.nan_reference,
                          odd.inf_reference, b.c_str(), odd.standard_errors) +
                formatted("%zu values mismatch; %zu pixels are not compared\n",
                          odd.nan_mismatched + odd.inf_mismatched, odd.pixels);
    if (odd.negative_picture + odd.negative_reference)
        text += formatted("negative: %zu values in %s, %zu in %s\n", odd.negative_picture,
                          a.c_str(), odd.negative_reference, b.c_str());
    return text;
}

}  // namespace

std::string to_text(const PictureMetrics& m, const std::string& picture,
                    const std::string& reference) {
    std::string text = formatted("%zu pixels compared", m.pixels);
    if (m.left_out) text += formatted(", %zu left out by the mask", m.left_out);
    text += formatted("; trimmed figures drop the worst %zu\n", m.trimmed);
    text += odd_text(m.odd, picture, reference);
    text += table_text(m, picture, reference);
    if (!m.p_same) return text;
    text += "\n" + tests_text(m);
    if (m.luminance_error_is_bound)
        text +=
            "luminance: its standard error is bounded by those of R, G and B, so its tests are "
            "careful ones\n";
    return text + formatted("p that chance alone makes R, G, B differ so: %.3g\n", *m.p_same);
}

}  // namespace lobe
