// SPDX-License-Identifier: Apache-2.0
// The laboratory's probe of a model, on the device under test and in long double's vectors.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/kernel_text.h"
#include "lab/brdf_probe.h"
#include "support/device.h"
#include "support/oracle.h"
#include "support/probe.h"

namespace lobe::test {

// Parameters by name over the model's defaults; a colour takes the number in all channels.
using BrdfValues = std::vector<std::pair<std::string, double>>;

// Real is float, or double for the oracle build of the same source.
template <typename Real>
class ModelProbe {
  public:
    // `texts` hide kernel files of their names; one may be the model itself.
    explicit ModelProbe(const std::string& model, const Texts& texts = {})
        : probe_(make(model, texts)) {}

    const std::string& name() const { return probe_.model().name; }

    // Every `items / sets.size()` consecutive items use the next set of parameters.
    std::vector<BrdfValue> eval(const std::vector<BrdfValues>& sets, const std::vector<vec3l>& wo,
                                const std::vector<vec3l>& wi) const {
        return probe_.eval(query(sets, wo, wi));
    }
    std::vector<BrdfSampled> sample(const std::vector<BrdfValues>& sets,
                                    const std::vector<vec3l>& wo,
                                    const std::vector<vec3l>& u) const {
        return probe_.sample(query(sets, wo, u));
    }

    std::size_t prepared_bytes() const { return probe_.prepared_bytes(); }

  private:
    static BrdfProbe make(const std::string& model, const Texts& texts) {
        KernelText kernels = test_kernels();
        for (const auto& [path, text] : texts) kernels.add(path, text);
        const std::string file = "brdf/" + model + ".h";
        return BrdfProbe(test_device(), kernels, parse_brdf_table(file, kernels.read(file)),
                         sizeof(Real) == sizeof(double) ? Precision::twice : Precision::single);
    }

    BrdfQuery query(const std::vector<BrdfValues>& sets, const std::vector<vec3l>& a,
                    const std::vector<vec3l>& b) const {
        if (a.size() != b.size() || a.size() % sets.size())
            throw std::runtime_error("arrays of unequal length");
        std::vector<BrdfRows> rows;
        for (const BrdfValues& values : sets) rows.push_back(brdf_rows(probe_.model(), values));
        probe_.set_parameters(rows);
        BrdfQuery query;
        for (std::size_t i = 0; i < a.size(); ++i)
            query.add(static_cast<std::uint32_t>(i / (a.size() / sets.size())), glm::dvec3(a[i]),
                      glm::dvec3(b[i]));
        return query;
    }

    mutable BrdfProbe probe_;
};

// The direction at an angle to the normal and an azimuth, both in radians.
inline vec3l direction(Long theta, Long phi = 0.7L) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

inline Long radians(Long degrees) { return degrees * pi / 180; }

}  // namespace lobe::test
