// SPDX-License-Identifier: Apache-2.0
// The sums of a render. Blocks of samples come from the device as floats, tile by tile, and are
// added in double along one binary tree aligned to block numbers, so that wherever a render is cut
// at a block, the same additions happen and the picture has the same bits.
#pragma once

#include <cstdint>
#include <vector>

#include "shared/frame.h"

namespace lobe {

// Sums over all samples so far, by pixel, row by row.
struct FilmSums {
    std::vector<double> radiance;         // pixel-major: LOBE_REPLICATES times r, g, b
    std::vector<std::uint32_t> emitters;  // samples that saw a light directly
    std::vector<std::uint32_t> samples;   // of each pixel
};

// A rectangle of pixels.
struct PixelBox {
    std::uint32_t x, y, width, height;
    std::size_t pixels() const { return static_cast<std::size_t>(width) * height; }
};

class Film {
  public:
    Film(std::uint32_t width, std::uint32_t height);

    std::uint32_t width() const { return width_; }
    std::uint32_t height() const { return height_; }
    std::size_t pixels() const { return static_cast<std::size_t>(width_) * height_; }

    // Tiles are counted row by row; those at the right and lower edge may be cut.
    std::uint32_t tiles() const { return static_cast<std::uint32_t>(tiles_.size()); }
    PixelBox tile_box(std::uint32_t tile) const;
    std::uint32_t tile_samples(std::uint32_t tile) const { return tiles_[tile].samples; }

    // Samples that every pixel has at least, and the mean over all pixels.
    std::uint32_t samples() const;
    double mean_samples() const;

    // Bytes of host memory that a render of so many samples of `pixels` pixels needs at its peak.
    static double peak_bytes(double pixels, std::uint64_t samples);
    // Throws Error (device) if the host has less: better refused than killed hours later.
    static void check_memory(double pixels, std::uint64_t samples);

    // Adds a tile's next block: sums of LOBE_TILE rows of LOBE_TILE pixels, LOBE_REPLICATES each;
    // those outside the film are not read. Only the last block of a tile may have fewer than
    // LOBE_BLOCK samples.
    void add_tile(std::uint32_t tile, const LobeBlockSum* sums, std::uint32_t samples);

    // Every tree's open subtrees added up from the youngest to the oldest.
    FilmSums sums() const;

  private:
    struct Tile {
        std::uint32_t samples = 0;
        std::vector<std::vector<double>> levels;  // [k]: a complete subtree of 2^k blocks, or empty
        std::vector<std::uint32_t> emitters;
    };

    std::uint32_t width_, height_, across_;
    std::vector<Tile> tiles_;
};

}  // namespace lobe
