// SPDX-License-Identifier: Apache-2.0
// A reflectance model on the device: its contract functions, called for arrays of inputs. The model
// needs to be nothing but a file that keeps the contract of kernels/brdf/README.md.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "cl/buffer.h"
#include "cl/program.h"
#include "scene/brdf_table.h"
#include "shared/types.h"

namespace lobe {

class KernelText;

// The parameters of a model: one row each, in the order of its table.
using BrdfRows = std::vector<std::array<float, 4>>;

// What NAME_claims says; the bits of kernels/brdf/brdf.h.
struct BrdfClaims {
    bool reciprocal, conserves_energy, keeps_samples;
};

// Inputs of a call: item i is asked of the parameter set sets[i].
struct BrdfQuery {
    std::vector<std::uint32_t> sets;
    std::vector<glm::dvec3> wo, second;  // wi, or the numbers u of a sample

    void add(std::uint32_t set, const glm::dvec3& view, const glm::dvec3& other) {
        sets.push_back(set);
        wo.push_back(view);
        second.push_back(other);
    }
    std::size_t size() const { return sets.size(); }
};

struct BrdfValue {
    glm::dvec3 f;  // times cos theta_i
    double pdf;    // 1/sr
};

struct BrdfSampled {
    glm::dvec3 wi;
    double pdf;
    glm::dvec3 weight;  // f cos theta_i / pdf; black: no sample
    bool delta;
};

// Float as the renderer runs it, or double: the oracle build of the same source.
enum class Precision { single, twice };

class BrdfProbe {
  public:
    // Builds the model's program. Throws Error as build_program does.
    BrdfProbe(const Device& device, const KernelText& kernels, const BrdfTable& model,
              Precision precision = Precision::single);

    // Sends the parameter sets that later calls name, and the numbers of tables they point into.
    void set_parameters(const std::vector<BrdfRows>& sets, const std::vector<float>& tables = {});

    std::vector<BrdfValue> eval(const BrdfQuery& query) const;
    std::vector<BrdfSampled> sample(const BrdfQuery& query) const;
    // f, not times the cosine, as NAME_formula gives it. The model must have one.
    std::vector<glm::dvec3> formula(const BrdfQuery& query) const;

    const BrdfTable& model() const { return model_; }
    Precision precision() const { return precision_; }
    const std::vector<BrdfClaims>& claims() const { return claims_; }  // one a set
    std::size_t prepared_bytes() const { return prepared_bytes_; }
    double compile_seconds() const { return program_.build_seconds; }

  private:
    template <typename Real>
    std::vector<double> run(const char* name, const BrdfQuery& query, std::size_t width) const;
    std::vector<double> run(const char* name, const BrdfQuery& query, std::size_t width) const;

    const Device& device_;
    BrdfTable model_;
    Precision precision_;
    Program program_;
    Buffer<LobeRow> rows_;
    Buffer<cl_uchar> prepared_;
    Buffer<cl_float> tables_;
    std::vector<BrdfClaims> claims_;
    std::size_t prepared_bytes_ = 0;
};

// The text of probe/brdf.cl for a model.
std::string brdf_probe_source(const KernelText& kernels, const BrdfTable& model);

// v as floats hold it: what the device is asked, and what the host reckons with.
inline glm::dvec3 rounded(const glm::dvec3& v) { return glm::dvec3(glm::vec3(v)); }

// The defaults of a model with some parameters changed, by name; a colour takes the number in all
// channels. Throws Error (usage) for a name that the model does not have.
BrdfRows brdf_rows(const BrdfTable& model,
                   const std::vector<std::pair<std::string, double>>& values = {});

}  // namespace lobe
