// SPDX-License-Identifier: Apache-2.0
// The film adds blocks along one tree that depends on block numbers only.
#include <gtest/gtest.h>

#include <functional>

#include "render/film.h"
#include "base/random.h"
#include "support/film_blocks.h"

using namespace lobe;
using lobe::test::add_block;

namespace {

// Sums of such different sizes that every order of adding has its own bits.
std::vector<LobeBlockSum> wild_block(std::size_t pixels, Random& random) {
    std::vector<LobeBlockSum> sums(pixels * LOBE_REPLICATES);
    for (LobeBlockSum& s : sums) {
        s.r = float(random.log_uniform(1e-9, 1e9));
        s.g = float(random.log_uniform(1e-3, 1e3));
        s.b = float(random.uniform());
        s.emitter = float(random.below(5));
    }
    return sums;
}

// The sum of red of blocks [first, first + count) of one replicate, count a power of two.
double tree_sum(const std::vector<std::vector<LobeBlockSum>>& blocks, std::size_t at,
                std::size_t first, std::size_t count) {
    if (count == 1) return blocks[first][at].r;
    return tree_sum(blocks, at, first, count / 2) +
           tree_sum(blocks, at, first + count / 2, count / 2);
}

// Complete subtrees from the left, the largest first; added up from the youngest to the oldest.
double aligned_sum(const std::vector<std::vector<LobeBlockSum>>& blocks, std::size_t at,
                   std::size_t count) {
    std::vector<double> subtrees;
    std::size_t first = 0;
    for (std::size_t size = std::size_t{1} << 20; size; size /= 2)
        if (count & size) {
            subtrees.push_back(tree_sum(blocks, at, first, size));
            first += size;
        }
    double sum = 0;
    for (std::size_t i = subtrees.size(); i-- > 0;) sum = subtrees[i] + sum;
    return sum;
}

}  // namespace

TEST(RenderFilm, BlocksOneByOneMakeTheAlignedTree) {
    Random random(1);
    Film film(3, 2);
    std::vector<std::vector<LobeBlockSum>> blocks;
    bool order_matters = false;
    for (std::size_t count = 1; count <= 40; ++count) {
        blocks.push_back(wild_block(film.pixels(), random));
        add_block(film, blocks.back(), LOBE_BLOCK);
        const FilmSums sums = film.sums();
        ASSERT_EQ(sums.samples[0], count * LOBE_BLOCK);
        for (std::size_t i = 0; i < film.pixels() * LOBE_REPLICATES; ++i) {
            ASSERT_EQ(sums.radiance[3 * i], aligned_sum(blocks, i, count)) << count << " blocks";
            double in_order = 0;
            for (const auto& block : blocks) in_order += block[i].r;
            order_matters |= in_order != sums.radiance[3 * i];
        }
    }
    EXPECT_TRUE(order_matters) << "the blocks do not tell one order from another";
}

TEST(RenderFilm, ChannelsReplicatesAndEmittersKeepTheirPlace) {
    Film film(2, 1);
    std::vector<LobeBlockSum> block(2 * LOBE_REPLICATES);
    for (std::size_t i = 0; i < block.size(); ++i)
        block[i] = {float(10 * i), float(10 * i + 1), float(10 * i + 2), float(i)};
    add_block(film, block, LOBE_BLOCK);
    add_block(film, block, 3);
    const FilmSums sums = film.sums();
    EXPECT_EQ(sums.samples, std::vector<std::uint32_t>(2, LOBE_BLOCK + 3u));
    for (std::size_t i = 0; i < block.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(sums.radiance[3 * i + c], 2.0 * (10 * i + c));
    for (std::size_t p = 0; p < 2; ++p) {
        std::uint32_t expected = 0;
        for (std::size_t k = 0; k < LOBE_REPLICATES; ++k)
            expected += 2 * std::uint32_t(p * LOBE_REPLICATES + k);
        EXPECT_EQ(sums.emitters[p], expected);
    }
}

// Ten million samples of 0.1: a float sum would be off by a hundredth.
TEST(RenderFilm, LongSumsStayExact) {
    Film film(1, 1);
    float eight = 0;
    for (int i = 0; i < LOBE_BLOCK / LOBE_REPLICATES; ++i) eight += 0.1f;
    std::vector<LobeBlockSum> block(LOBE_REPLICATES, LobeBlockSum{eight, eight, eight, 0});
    for (int i = 0; i < 1250000; ++i) add_block(film, block, LOBE_BLOCK);
    const FilmSums sums = film.sums();
    double total = 0;
    for (std::size_t k = 0; k < LOBE_REPLICATES; ++k) total += sums.radiance[3 * k];
    EXPECT_NEAR(total / double(sums.samples[0]), 0.1, 1e-7);
}

// Tiles of a film that no tile divides, each with its own number of blocks.
TEST(RenderFilm, TilesAreOnTheirOwn) {
    Random random(2);
    Film film(LOBE_TILE + 3, LOBE_TILE + 1);
    ASSERT_EQ(film.tiles(), 4u);
    std::vector<std::vector<LobeBlockSum>> blocks;
    for (std::uint32_t t = 0; t < 4; ++t)
        for (std::uint32_t k = 0; k <= t; ++k) {
            blocks.push_back(wild_block(LOBE_TILE * LOBE_TILE, random));
            film.add_tile(t, blocks.back().data(), LOBE_BLOCK);
        }
    EXPECT_EQ(film.samples(), std::uint32_t{LOBE_BLOCK});
    const double pixels = film.pixels();
    EXPECT_NEAR(film.mean_samples(), LOBE_BLOCK * (256 + 2 * 48 + 3 * 16 + 4 * 3) / pixels, 1e-12);
    const FilmSums sums = film.sums();
    const std::size_t first[] = {0, 1, 3, 6};
    for (std::uint32_t y = 0; y < film.height(); ++y)
        for (std::uint32_t x = 0; x < film.width(); ++x) {
            const std::uint32_t t = x / LOBE_TILE + 2 * (y / LOBE_TILE);
            const std::size_t p = std::size_t{y} * film.width() + x;
            const std::size_t at = ((y % LOBE_TILE) * LOBE_TILE + x % LOBE_TILE) * LOBE_REPLICATES;
            const std::vector<std::vector<LobeBlockSum>> own(
                blocks.begin() + std::ptrdiff_t(first[t]),
                blocks.begin() + std::ptrdiff_t(first[t] + t + 1));
            ASSERT_EQ(sums.samples[p], LOBE_BLOCK * (t + 1));
            ASSERT_EQ(sums.radiance[p * LOBE_REPLICATES * 3], aligned_sum(own, at, t + 1));
        }
}

TEST(RenderFilm, EmptyFilmHasNoSamples) {
    const FilmSums sums = Film(2, 2).sums();
    EXPECT_EQ(sums.samples, std::vector<std::uint32_t>(4, 0u));
    EXPECT_EQ(sums.radiance, std::vector<double>(4 * LOBE_REPLICATES * 3, 0.0));
}
