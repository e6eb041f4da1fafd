// SPDX-License-Identifier: Apache-2.0
#include "report/metrics_report.h"

namespace lobe {
namespace {

using Json = nlohmann::ordered_json;

Json optional_number(const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json to_json(const Deviation& d) {
    return {{"difference", d.difference},
            {"standard_error", d.standard_error},
            {"degrees_of_freedom", d.freedom},
            {"t", d.t},
            {"p", d.p}};
}

Json to_json(const Block& b) {
    return {{"x", b.x},           {"y", b.y},           {"width", b.width},
            {"height", b.height}, {"pixels", b.pixels}, {"difference", b.difference}};
}

Json to_json(const MeanTest& t) {
    Json worst = to_json(t.worst.block);
    worst.update(to_json(t.worst.deviation));
    return {{"image", to_json(t.image)},
            {"blocks", t.blocks},
            {"worst_block", worst},
            {"blocks_p", t.blocks_p},
            {"chi_square", t.chi_square},
            {"chi_square_p", t.chi_square_p},
            {"p", t.p}};
}

Json to_json(const ChannelMetrics& m) {
    return {
        {"picture_mean", m.picture_mean},
        {"reference_mean", m.reference_mean},
        {"mean_difference", m.mean_difference},
        {"mse_raw", m.mse_raw},
        {"mse", optional_number(m.mse)},
        {"mse_standard_error", optional_number(m.mse_standard_error)},
        {"mse_trimmed", m.mse_trimmed},
        {"mse_trimmed_share", m.mse_trimmed_share},
        {"bias_squared", optional_number(m.bias_squared)},
        {"bias_squared_standard_error", optional_number(m.bias_squared_standard_error)},
        {"rmse", m.rmse},
        {"relative_rmse", m.relative_rmse},
        {"relmse_epsilon", m.relmse_epsilon},
        {"relmse_raw", m.relmse_raw},
        {"relmse", optional_number(m.relmse)},
        {"relmse_trimmed", m.relmse_trimmed},
        {"relmse_trimmed_share", m.relmse_trimmed_share},
        {"smape", m.smape},
        {"mean_absolute_error", m.mean_absolute_error},
        {"absolute_error", {{"median", m.median}, {"p95", m.p95}, {"p99", m.p99}, {"max", m.max}}},
        {"max_at", {m.max_x, m.max_y}},
        {"blocks", m.blocks},
        {"block_rmse", m.block_rmse},
        {"worst_block", to_json(m.worst_block)},
        {"test", m.test ? to_json(*m.test) : Json(nullptr)}};
}

Json to_json(const OddValues& odd) {
    return {{"nan_picture", odd.nan_picture},
            {"nan_reference", odd.nan_reference},
            {"nan_mismatched", odd.nan_mismatched},
            {"inf_picture", odd.inf_picture},
            {"inf_reference", odd.inf_reference},
            {"inf_mismatched", odd.inf_mismatched},
            {"standard_errors", odd.standard_errors},
            {"pixels", odd.pixels},
            {"first_at", odd.pixels ? Json({odd.first_x, odd.first_y}) : Json(nullptr)},
            {"negative_picture", odd.negative_picture},
            {"negative_reference", odd.negative_reference}};
}

}  // namespace

Json to_json(const PictureMetrics& m) {
    Json channels = Json::object();
    for (const ChannelMetrics& c : m.channels) channels[c.name] = to_json(c);
    return {{"compared_pixels", m.pixels},
            {"left_out_pixels", m.left_out},
            {"odd_values", to_json(m.odd)},
            {"block_pixels", m.block},
            {"trimmed_pixels", m.trimmed},
            {"luminance_error_is_bound", m.luminance_error_is_bound},
            {"p_same", optional_number(m.p_same)},
            {"channels", channels}};
}

}  // namespace lobe
