// SPDX-License-Identifier: Apache-2.0
// Blocks of a whole film, for tests that make their own.
#pragma once

#include "render/film.h"

namespace lobe::test {

// Adds a block to every tile: LOBE_REPLICATES sums a pixel, pixels row by row.
inline void add_block(Film& film, const std::vector<LobeBlockSum>& sums, std::uint32_t samples) {
    for (std::uint32_t t = 0; t < film.tiles(); ++t) {
        const PixelBox box = film.tile_box(t);
        std::vector<LobeBlockSum> tile(LOBE_TILE * LOBE_TILE * LOBE_REPLICATES);
        for (std::uint32_t y = 0; y < box.height; ++y)
            for (std::uint32_t x = 0; x < box.width * LOBE_REPLICATES; ++x)
                tile[y * LOBE_TILE * LOBE_REPLICATES + x] =
                    sums[(std::size_t{box.y + y} * film.width() + box.x) * LOBE_REPLICATES + x];
        film.add_tile(t, tile.data(), samples);
    }
}

}  // namespace lobe::test
