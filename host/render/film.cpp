// SPDX-License-Identifier: Apache-2.0
#include "render/film.h"

#include <unistd.h>

#include <algorithm>

#include "base/error.h"
#include "base/progress.h"

namespace lobe {
namespace {

// later = earlier + later, the order in which the tree adds.
void add_to(std::vector<double>& later, const std::vector<double>& earlier) {
    for (std::size_t i = 0; i < later.size(); ++i) later[i] = earlier[i] + later[i];
}

std::uint32_t tiles_along(std::uint32_t pixels) { return (pixels + LOBE_TILE - 1) / LOBE_TILE; }

}  // namespace

Film::Film(std::uint32_t width, std::uint32_t height)
    : width_(width), height_(height), across_(tiles_along(width)) {
    tiles_.resize(std::size_t{across_} * tiles_along(height));
    for (std::uint32_t t = 0; t < tiles(); ++t) tiles_[t].emitters.resize(tile_box(t).pixels());
}

PixelBox Film::tile_box(std::uint32_t tile) const {
    const std::uint32_t x = tile % across_ * LOBE_TILE, y = tile / across_ * LOBE_TILE;
    return {x, y, std::min<std::uint32_t>(LOBE_TILE, width_ - x),
            std::min<std::uint32_t>(LOBE_TILE, height_ - y)};
}

std::uint32_t Film::samples() const {
    std::uint32_t least = tiles_.empty() ? 0 : tiles_[0].samples;
    for (const Tile& tile : tiles_) least = std::min(least, tile.samples);
    return least;
}

double Film::mean_samples() const {
    double total = 0;
    for (std::uint32_t t = 0; t < tiles(); ++t)
        total += static_cast<double>(tile_box(t).pixels()) * tiles_[t].samples;
    return pixels() ? total / static_cast<double>(pixels()) : 0;
}

double Film::peak_bytes(double pixels, std::uint64_t samples) {
    double subtrees = 1;  // open ones of the tree
    for (std::uint64_t blocks = samples / LOBE_BLOCK; blocks; blocks >>= 1) ++subtrees;
    const double block = LOBE_REPLICATES * sizeof(LobeBlockSum);
    return pixels *
           (subtrees * LOBE_REPLICATES * 3 * sizeof(double) + block + sizeof(std::uint32_t));
}

void Film::check_memory(double pixels, std::uint64_t samples) {
    const double needed = peak_bytes(pixels, samples);
    const double there = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * sysconf(_SC_PAGESIZE);
    if (needed > there)
        throw Error(ExitCode::device,
                    "the film needs " + bytes_text(needed) + " of host memory, there are " +
                        bytes_text(there),
                    "", "render a part with --crop, or fewer samples");
}

void Film::add_tile(std::uint32_t tile, const LobeBlockSum* sums, std::uint32_t samples) {
    Tile& t = tiles_[tile];
    const PixelBox box = tile_box(tile);
    std::vector<double> carry(box.pixels() * LOBE_REPLICATES * 3);
    double* to = carry.data();
    for (std::uint32_t y = 0; y < box.height; ++y) {
        const LobeBlockSum* from = sums + std::size_t{y} * LOBE_TILE * LOBE_REPLICATES;
        for (std::uint32_t x = 0; x < box.width * LOBE_REPLICATES; ++x, ++from) {
            *to++ = from->r;
            *to++ = from->g;
            *to++ = from->b;
            t.emitters[std::size_t{y} * box.width + x / LOBE_REPLICATES] +=
                static_cast<std::uint32_t>(from->emitter);
        }
    }
    std::size_t level = 0;
    for (; level < t.levels.size() && !t.levels[level].empty(); ++level) {
        add_to(carry, t.levels[level]);
        t.levels[level] = {};
    }
    if (level == t.levels.size()) t.levels.emplace_back();
    t.levels[level] = std::move(carry);
    t.samples += samples;
}

FilmSums Film::sums() const {
    constexpr std::size_t numbers = LOBE_REPLICATES * 3;
    FilmSums total;
    total.radiance.resize(pixels() * numbers);
    total.emitters.resize(pixels());
    total.samples.resize(pixels());
    for (std::uint32_t i = 0; i < tiles(); ++i) {
        const Tile& tile = tiles_[i];
        const PixelBox box = tile_box(i);
        std::vector<double> sum(box.pixels() * numbers);
        for (const std::vector<double>& level : tile.levels)
            if (!level.empty()) add_to(sum, level);
        for (std::uint32_t y = 0; y < box.height; ++y) {
            const std::size_t from = std::size_t{y} * box.width;
            const std::size_t to = std::size_t{box.y + y} * width_ + box.x;
            std::copy_n(&sum[from * numbers], box.width * numbers, &total.radiance[to * numbers]);
            std::copy_n(&tile.emitters[from], box.width, &total.emitters[to]);
            std::fill_n(&total.samples[to], box.width, tile.samples);
        }
    }
    return total;
}

}  // namespace lobe
