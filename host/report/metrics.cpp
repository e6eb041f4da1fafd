// SPDX-License-Identifier: Apache-2.0
#include "report/metrics.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/luminance.h"
#include "report/channel_metrics.h"

namespace lobe {
namespace {

bool given(const std::vector<float>* values) { return values && !values->empty(); }

void check_sizes(const PictureView& a, const PictureView& b, const MetricsOptions& options) {
    const std::size_t pixels = std::size_t(a.width) * a.height;
    bool fit = a.width == b.width && a.height == b.height && options.block > 0;
    for (const PictureView* view : {&a, &b}) {
        fit = fit && view->rgb && view->rgb->size() == 3 * pixels;
        fit = fit && (!given(view->standard_error) || view->standard_error->size() == 3 * pixels);
        fit = fit && (!given(view->luminance_error) || view->luminance_error->size() == pixels);
    }
    if (options.left_out) fit = fit && options.left_out->size() == pixels;
    if (!fit) throw Error(ExitCode::internal, "pictures and masks of unlike sizes are compared");
}

// Whether all of these standard errors can be such; counts those that cannot.
bool count_errors(OddValues& odd, const std::vector<float>* errors, std::size_t first,
                  std::size_t count) {
    if (!given(errors)) return true;
    std::size_t bad = 0;
    for (std::size_t i = first; i < first + count; ++i)
        bad += !(std::isfinite((*errors)[i]) && (*errors)[i] >= 0);
    odd.standard_errors += bad;
    return bad == 0;
}

// Counts the odd values of a pixel; whether it can be compared.
bool count_values(OddValues& odd, const PictureView& a, const PictureView& b, std::size_t pixel) {
    bool good = true;
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
        const float x = (*a.rgb)[i], y = (*b.rgb)[i];
        odd.nan_picture += std::isnan(x);
        odd.nan_reference += std::isnan(y);
        odd.nan_mismatched += std::isnan(x) != std::isnan(y);
        odd.inf_picture += std::isinf(x);
        odd.inf_reference += std::isinf(y);
        odd.inf_mismatched += (std::isinf(x) || std::isinf(y)) && x != y;
        odd.negative_picture += x < 0;
        odd.negative_reference += y < 0;
        good = good && std::isfinite(x) && std::isfinite(y);
    }
    for (const PictureView* view : {&a, &b}) {
        good &= count_errors(odd, view->standard_error, 3 * pixel, 3);
        good &= count_errors(odd, view->luminance_error, pixel, 1);
    }
    if (!good && odd.pixels++ == 0) {
        odd.first_x = static_cast<std::uint32_t>(pixel) % a.width;
        odd.first_y = static_cast<std::uint32_t>(pixel) / a.width;
    }
    return good;
}

// The pixels to compare; counts the others.
std::vector<std::uint32_t> choose_pixels(PictureMetrics& m, const PictureView& a,
                                         const PictureView& b, const std::vector<bool>* left_out) {
    std::vector<std::uint32_t> place;
    for (std::size_t p = 0; p < std::size_t(a.width) * a.height; ++p) {
        const bool good = count_values(m.odd, a, b, p);
        if (left_out && (*left_out)[p])
            ++m.left_out;
        else if (good)
            place.push_back(static_cast<std::uint32_t>(p));
    }
    return place;
}

constexpr int luminance_channel = -1;

double value_of(const std::vector<float>& rgb, std::size_t pixel, int channel) {
    const float* v = &rgb[3 * pixel];
    return channel == luminance_channel ? luminance(v) : v[channel];
}

// Empty where unknown.
std::vector<double> variances(const PictureView& view, const std::vector<std::uint32_t>& place,
                              int channel) {
    const bool own = channel == luminance_channel && given(view.luminance_error);
    std::vector<double> result;
    if (!own && !given(view.standard_error)) return result;
    result.reserve(place.size());
    for (const std::uint32_t p : place) {
        const double error =
            own ? (*view.luminance_error)[p] : value_of(*view.standard_error, p, channel);
        result.push_back(error * error);
    }
    return result;
}

ChannelPair pair_of(const PictureView& a, const PictureView& b,
                    const std::vector<std::uint32_t>& place, int channel) {
    ChannelPair pair;
    pair.width = a.width;
    pair.height = a.height;
    pair.place = place;
    pair.picture.reserve(place.size());
    pair.reference.reserve(place.size());
    for (const std::uint32_t p : place) {
        pair.picture.push_back(value_of(*a.rgb, p, channel));
        pair.reference.push_back(value_of(*b.rgb, p, channel));
    }
    pair.picture_variance = variances(a, place, channel);
    pair.reference_variance = variances(b, place, channel);
    pair.picture_freedom = a.freedom;
    pair.reference_freedom = b.freedom;
    return pair;
}

// Half of the level for the image's mean, half for the blocks; within each half the least p of all
// channels. Sidak's bound holds for correlated tests too (JASA 62, 1967).
std::optional<double> chance(const std::vector<ChannelMetrics>& channels) {
    double image = 1, block = 1, tests = 0, blocks = 0;
    for (const ChannelMetrics& m : channels) {
        if (m.name == "luminance") continue;
        if (!m.test) return {};
        image = std::min(image, m.test->image.p);
        block = std::min(block, m.test->worst.deviation.p);
        tests += 1;
        blocks += static_cast<double>(m.test->blocks);
    }
    return std::min(1.0, 2 * std::min(sidak_p(image, tests), sidak_p(block, blocks)));
}

}  // namespace

PictureMetrics compare_pictures(const PictureView& picture, const PictureView& reference,
                                const MetricsOptions& options) {
    check_sizes(picture, reference, options);
    PictureMetrics m;
    const std::vector<std::uint32_t> place = choose_pixels(m, picture, reference, options.left_out);
    m.pixels = place.size();
    m.block = options.block;
    m.trimmed = static_cast<std::size_t>(std::ceil(options.trim * static_cast<double>(m.pixels)));
    for (const PictureView* view : {&picture, &reference})
        if (given(view->standard_error) && !given(view->luminance_error))
            m.luminance_error_is_bound = true;
    const std::array<const char*, 4> names = {"luminance", "R", "G", "B"};
    for (int c = luminance_channel; c < 3; ++c) {
        const std::string name = names[static_cast<std::size_t>(c + 1)];
        if (place.empty())
            m.channels.push_back({name});
        else
            m.channels.push_back(
                measure_channel(name, pair_of(picture, reference, place, c), m.block, m.trimmed));
    }
    if (!place.empty()) m.p_same = chance(m.channels);
    return m;
}

}  // namespace lobe
