// SPDX-License-Identifier: Apache-2.0
// How the path tracer spends its samples. These choices change the noise of a picture, never what
// it converges to (but cosine directions never meet a perfect mirror). They are structure: the
// kernel is compiled for them.
#pragma once

#include <string>

namespace lobe {

struct Integrator {
    enum class Sampler { sobol, independent };  // Owen-scrambled Sobol, or hashed numbers
    enum class Strategy { both, light, brdf };  // how lights are found
    enum class Heuristic { power, balance };    // weights of `both`
    enum class Directions { matched, cosine };  // of scattering: the model's own, or cosine

    Sampler sampler = Sampler::sobol;
    Strategy strategy = Strategy::both;
    Heuristic heuristic = Heuristic::power;
    Directions directions = Directions::matched;
};

// "sobol, matched directions, both strategies, power heuristic".
std::string to_text(const Integrator& integrator);

}  // namespace lobe
