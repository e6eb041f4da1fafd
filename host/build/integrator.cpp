// SPDX-License-Identifier: Apache-2.0
#include "build/integrator.h"

namespace lobe {

std::string to_text(const Integrator& i) {
    std::string text = i.sampler == Integrator::Sampler::sobol ? "sobol" : "independent";
    text += i.directions == Integrator::Directions::matched ? ", matched directions"
                                                            : ", cosine directions";
    if (i.strategy == Integrator::Strategy::light) return text + ", light strategy";
    if (i.strategy == Integrator::Strategy::brdf) return text + ", brdf strategy";
    text += ", both strategies";
    return text + (i.heuristic == Integrator::Heuristic::power ? ", power heuristic"
                                                               : ", balance heuristic");
}

}  // namespace lobe
