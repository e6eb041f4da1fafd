// SPDX-License-Identifier: Apache-2.0
// The contract functions of any reflectance model, called on the device for arrays of inputs. The
// model needs to be nothing but a file that keeps the contract of kernels/brdf/README.md.
#pragma once

#include <array>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "base/kernel_text.h"
#include "scene/brdf_table.h"
#include "shared/types.h"
#include "support/oracle.h"
#include "support/probe.h"

namespace lobe::test {

// Parameters by name over the model's defaults; a colour takes the number in all channels.
using BrdfValues = std::vector<std::pair<std::string, double>>;

struct BrdfValue {
    glm::dvec3 f;  // times cos theta_i
    double pdf;
};

struct BrdfSampled {
    glm::dvec3 wi;
    double pdf;
    glm::dvec3 weight;
    bool delta;
};

// Real is float, or double for the oracle build of the same source.
template <typename Real>
class BrdfProbe {
  public:
    // `file` holds the model; it may be one of `texts`, as a user's own would be.
    explicit BrdfProbe(const std::string& model, Texts texts = {}) : name_(model) {
        const std::string file = "brdf/" + model + ".h";
        const auto own = texts.find(file);
        table_ = parse_brdf_table(file, own != texts.end() ? own->second : KernelText().read(file));
        texts["probe_brdf.h"] =
            "#include \"" + file + "\"\n#define LOBE_PROBE_BRDF " + model + "\n";
        ProgramOptions options;
        options.double_precision = sizeof(Real) == sizeof(double);
        program_ = build_probe("probe/brdf.cl", texts, options);
    }

    const std::string& name() const { return name_; }

    // Every `items / sets.size()` consecutive items use the next set of parameters.
    std::vector<BrdfValue> eval(const std::vector<BrdfValues>& sets, const std::vector<vec3l>& wo,
                                const std::vector<vec3l>& wi) const {
        const std::vector<Real> out = run("brdf_eval", sets, wo, wi, 4);
        std::vector<BrdfValue> values(wo.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = {{out[4 * i], out[4 * i + 1], out[4 * i + 2]}, out[4 * i + 3]};
        return values;
    }

    std::vector<BrdfSampled> sample(const std::vector<BrdfValues>& sets,
                                    const std::vector<vec3l>& wo,
                                    const std::vector<vec3l>& u) const {
        const std::vector<Real> out = run("brdf_sample", sets, wo, u, 8);
        std::vector<BrdfSampled> samples(wo.size());
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const Real* o = &out[8 * i];
            samples[i] = {{o[0], o[1], o[2]}, o[3], {o[4], o[5], o[6]}, o[7] != 0};
        }
        return samples;
    }

    std::size_t prepared_bytes() const {
        Buffer<cl_uint> out(test_device(), 1);
        run_probe(program_, "brdf_size", 1, out);
        return out.read_all()[0];
    }

  private:
    // One group size for all calls: PoCL compiles a kernel anew for each.
    static constexpr std::size_t group = 64;

    static Buffer<Real> upload(const std::vector<vec3l>& vectors, std::size_t padded) {
        std::vector<Real> numbers(3 * padded, Real(0.5));
        for (std::size_t i = 0; i < vectors.size(); ++i)
            for (int k = 0; k < 3; ++k) numbers[3 * i + k] = static_cast<Real>(vectors[i][k]);
        return Buffer<Real>(test_device(), numbers);
    }

    std::vector<LobeRow> rows(const std::vector<BrdfValues>& sets) const {
        std::vector<LobeRow> all;
        for (const BrdfValues& values : sets) {
            auto rows = table_.default_rows();
            for (const auto& [name, value] : values) {
                const int place = table_.find(name);
                if (place < 0) throw std::runtime_error(name_ + " has no " + name);
                rows[place].fill(static_cast<float>(value));
            }
            for (const auto& row : rows) all.push_back({row[0], row[1], row[2], row[3]});
        }
        for (const auto& row : table_.default_rows())  // for the padding
            all.push_back({row[0], row[1], row[2], row[3]});
        return all;
    }

    std::vector<Real> run(const char* name, const std::vector<BrdfValues>& sets,
                          const std::vector<vec3l>& a, const std::vector<vec3l>& b,
                          std::size_t width) const {
        if (a.size() != b.size() || a.size() % sets.size())
            throw std::runtime_error("arrays of unequal length");
        const std::size_t padded = (a.size() + group - 1) / group * group;
        const auto per_set = std::max(static_cast<cl_uint>(a.size() / sets.size()), cl_uint(group));
        if (sets.size() > 1 && a.size() / sets.size() < group)
            throw std::runtime_error("fewer items a set than a group");
        Buffer<Real> out(test_device(), width * padded);
        const Buffer<LobeRow> table(test_device(), rows(sets));
        const Buffer<Real> first = upload(a, padded), second = upload(b, padded);
        cl::Kernel kernel = program_.kernel(name);
        set_args(kernel, table, static_cast<cl_uint>(table_.parameters.size()), per_set, first,
                 second, out);
        launch(test_device(), kernel, cl::NDRange(padded), cl::NDRange(group));
        test_device().finish();
        return out.read_all();
    }

    std::string name_;
    BrdfTable table_;
    Program program_;
};

// The direction at an angle to the normal and an azimuth, both in radians.
inline vec3l direction(Long theta, Long phi = 0.7L) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

inline Long radians(Long degrees) { return degrees * pi / 180; }

}  // namespace lobe::test
