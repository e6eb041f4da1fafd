// SPDX-License-Identifier: Apache-2.0
// The same numbers on every machine, which the standard library's distributions do not promise.
#pragma once

#include <cmath>
#include <cstdint>

namespace lobe {

// SplitMix64 (Steele, Lea, Flood, "Fast splittable pseudorandom number generators", 2014).
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    std::uint32_t word() { return static_cast<std::uint32_t>(bits() >> 32); }
    // In [0, 1), a multiple of 2^-53; as float a multiple of 2^-24.
    double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    float uniform_float() { return static_cast<float>(bits() >> 40) * 0x1p-24f; }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    // Evenly spread in the logarithm, for values over many orders of magnitude.
    double log_uniform(double low, double high) { return low * std::pow(high / low, uniform()); }
    // In [0, count).
    std::uint32_t below(std::uint32_t count) {
        return static_cast<std::uint32_t>((bits() >> 32) * count >> 32);
    }
    double normal() {
        const double radius = std::sqrt(-2 * std::log1p(-uniform()));
        return radius * std::cos(6.283185307179586 * uniform());
    }

  private:
    std::uint64_t state_;
};

}  // namespace lobe
