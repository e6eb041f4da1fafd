// SPDX-License-Identifier: Apache-2.0
#include "report/channel_metrics.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/statistics.h"

namespace lobe {
namespace {

double ratio(double a, double b) { return a == 0 ? 0 : a / b; }

// The mean without the largest values, and how much of the sum those hold.
struct Trimmed {
    double mean = 0, share = 0;
};
Trimmed trimmed_mean(std::vector<double> values, std::size_t drop) {
    const auto end = values.begin() + static_cast<std::ptrdiff_t>(drop);
    std::nth_element(values.begin(), end, values.end(), std::greater<>());
    double dropped = 0, kept = 0;
    for (auto v = values.begin(); v != end; ++v) dropped += *v;
    for (auto v = end; v != values.end(); ++v) kept += *v;
    const std::size_t left = values.size() - drop;
    return {left ? kept / static_cast<double>(left) : 0, ratio(dropped, dropped + kept)};
}

// Of sorted values, linear between neighbours: 0 gives the least, 1 the largest.
double quantile(const std::vector<double>& sorted, double p) {
    const double at = p * static_cast<double>(sorted.size() - 1);
    const auto low = static_cast<std::size_t>(at);
    const std::size_t high = std::min(low + 1, sorted.size() - 1);
    return sorted[low] + (at - std::floor(at)) * (sorted[high] - sorted[low]);
}

void fill_absolute(ChannelMetrics& m, const ChannelPair& pair) {
    std::vector<double> size(pair.place.size());
    double smape = 0;
    for (std::size_t i = 0; i < size.size(); ++i) {
        size[i] = std::fabs(pair.picture[i] - pair.reference[i]);
        smape += ratio(2 * size[i], std::fabs(pair.picture[i]) + std::fabs(pair.reference[i]));
    }
    m.smape = smape / static_cast<double>(size.size());
    m.mean_absolute_error = mean(size);
    const std::uint32_t worst = pair.place[static_cast<std::size_t>(
        std::max_element(size.begin(), size.end()) - size.begin())];
    m.max_x = worst % pair.width;
    m.max_y = worst / pair.width;
    std::sort(size.begin(), size.end());
    m.median = quantile(size, 0.5);
    m.p95 = quantile(size, 0.95);
    m.p99 = quantile(size, 0.99);
    m.max = size.back();
}

void fill_squared(ChannelMetrics& m, const ChannelPair& pair, std::size_t trimmed) {
    std::vector<double> squares(pair.place.size());
    for (std::size_t i = 0; i < squares.size(); ++i)
        squares[i] = (pair.picture[i] - pair.reference[i]) * (pair.picture[i] - pair.reference[i]);
    m.mse_raw = mean(squares);
    m.rmse = std::sqrt(m.mse_raw);
    m.relative_rmse = ratio(m.rmse, std::fabs(m.reference_mean));
    const Trimmed rest = trimmed_mean(squares, trimmed);
    m.mse_trimmed = rest.mean;
    m.mse_trimmed_share = rest.share;
    if (pair.reference_variance.empty()) return;
    for (std::size_t i = 0; i < squares.size(); ++i) squares[i] -= pair.reference_variance[i];
    m.mse = mean(squares);
    if (squares.size() > 1) m.mse_standard_error = standard_error(squares);
    if (pair.picture_variance.empty()) return;
    for (std::size_t i = 0; i < squares.size(); ++i) squares[i] -= pair.picture_variance[i];
    m.bias_squared = mean(squares);
    if (squares.size() > 1) m.bias_squared_standard_error = standard_error(squares);
}

void fill_relative(ChannelMetrics& m, const ChannelPair& pair, std::size_t trimmed) {
    m.relmse_epsilon = 1e-2 * m.reference_mean * m.reference_mean;
    std::vector<double> parts(pair.place.size());
    double variance = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const double d = pair.picture[i] - pair.reference[i];
        const double size = pair.reference[i] * pair.reference[i] + m.relmse_epsilon;
        parts[i] = ratio(d * d, size);
        if (!pair.reference_variance.empty()) variance += ratio(pair.reference_variance[i], size);
    }
    m.relmse_raw = mean(parts);
    if (!pair.reference_variance.empty())
        m.relmse = m.relmse_raw - variance / static_cast<double>(parts.size());
    const Trimmed rest = trimmed_mean(parts, trimmed);
    m.relmse_trimmed = rest.mean;
    m.relmse_trimmed_share = rest.share;
}

// Of the squared differences of the blocks' means, each block as heavy as it has pixels.
void fill_blocks(ChannelMetrics& m, const ChannelPair& pair, std::uint32_t side) {
    const std::vector<BlockTest> blocks = test_blocks(pair, side);
    double sum = 0;
    for (const BlockTest& b : blocks) {
        sum += static_cast<double>(b.block.pixels) * b.block.difference * b.block.difference;
        if (std::fabs(b.block.difference) >= std::fabs(m.worst_block.difference))
            m.worst_block = b.block;
    }
    m.blocks = blocks.size();
    m.block_rmse = std::sqrt(sum / static_cast<double>(pair.place.size()));
    if (pair.has_errors()) m.test = test_means(pair, blocks);
}

}  // namespace

ChannelMetrics measure_channel(const std::string& name, const ChannelPair& pair,
                               std::uint32_t block, std::size_t trimmed) {
    ChannelMetrics m;
    m.name = name;
    m.picture_mean = mean(pair.picture);
    m.reference_mean = mean(pair.reference);
    m.mean_difference = m.picture_mean - m.reference_mean;
    fill_squared(m, pair, trimmed);
    fill_relative(m, pair, trimmed);
    fill_absolute(m, pair);
    fill_blocks(m, pair, block);
    return m;
}

}  // namespace lobe
