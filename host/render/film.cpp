// SPDX-License-Identifier: Apache-2.0
#include "render/film.h"

namespace lobe {
namespace {

// later = earlier + later, the order in which the tree adds.
void add_to(std::vector<double>& later, const std::vector<double>& earlier) {
    for (std::size_t i = 0; i < later.size(); ++i) later[i] = earlier[i] + later[i];
}

}  // namespace

Film::Film(std::uint32_t width, std::uint32_t height)
    : width_(width), height_(height), emitters_(pixels(), 0) {}

double Film::peak_bytes(double pixels, std::uint64_t samples) {
    double subtrees = 1;  // open ones of the tree and the one that is carried
    for (std::uint64_t blocks = samples / LOBE_BLOCK; blocks; blocks >>= 1) ++subtrees;
    const double block = LOBE_REPLICATES * sizeof(LobeBlockSum);
    return pixels *
           (subtrees * LOBE_REPLICATES * 3 * sizeof(double) + block + sizeof(std::uint32_t));
}

void Film::add_block(const std::vector<LobeBlockSum>& sums, std::uint32_t samples) {
    std::vector<double> carry(pixels() * LOBE_REPLICATES * 3);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        carry[3 * i] = sums[i].r;
        carry[3 * i + 1] = sums[i].g;
        carry[3 * i + 2] = sums[i].b;
        emitters_[i / LOBE_REPLICATES] += static_cast<std::uint32_t>(sums[i].emitter);
    }
    std::size_t level = 0;
    for (; level < levels_.size() && !levels_[level].empty(); ++level) {
        add_to(carry, levels_[level]);
        levels_[level] = {};
    }
    if (level == levels_.size()) levels_.emplace_back();
    levels_[level] = std::move(carry);
    samples_ += samples;
}

FilmSums Film::sums() const {
    FilmSums total;
    total.samples = samples_;
    total.emitters = emitters_;
    total.radiance.assign(pixels() * LOBE_REPLICATES * 3, 0.0);
    for (const std::vector<double>& level : levels_)
        if (!level.empty()) add_to(total.radiance, level);
    return total;
}

}  // namespace lobe
