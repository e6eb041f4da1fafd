// SPDX-License-Identifier: Apache-2.0
// The sums of a render. Blocks of samples come from the device as floats and are added in double
// along one binary tree aligned to block numbers, so that wherever a render is cut at a block, the
// same additions happen and the picture has the same bits.
#pragma once

#include <cstdint>
#include <vector>

#include "shared/frame.h"

namespace lobe {

// Sums over all samples so far, by pixel.
struct FilmSums {
    std::vector<double> radiance;         // pixel-major: LOBE_REPLICATES times r, g, b
    std::vector<std::uint32_t> emitters;  // samples that saw a light directly
    std::uint64_t samples = 0;            // per pixel
};

class Film {
  public:
    Film(std::uint32_t width, std::uint32_t height);

    std::uint32_t width() const { return width_; }
    std::uint32_t height() const { return height_; }
    std::size_t pixels() const { return static_cast<std::size_t>(width_) * height_; }
    std::uint64_t samples() const { return samples_; }

    // Bytes of host memory that a render of so many samples of `pixels` pixels needs at its peak.
    static double peak_bytes(double pixels, std::uint64_t samples);

    // Adds the next block in order: `sums` has LOBE_REPLICATES entries a pixel. Only the last block
    // of a render may have fewer than LOBE_BLOCK samples.
    void add_block(const std::vector<LobeBlockSum>& sums, std::uint32_t samples);

    // Says that the block just added lacks some rows: a first look that was interrupted. Its errors
    // are then unknown.
    void mark_incomplete() { complete_ = false; }
    bool complete() const { return complete_; }

    // The tree's open subtrees added up from the youngest to the oldest.
    FilmSums sums() const;

  private:
    std::uint32_t width_, height_;
    std::uint64_t samples_ = 0;
    bool complete_ = true;
    std::vector<std::vector<double>>
        levels_;  // levels_[k]: a complete subtree of 2^k blocks, or empty
    std::vector<std::uint32_t> emitters_;
};

}  // namespace lobe
