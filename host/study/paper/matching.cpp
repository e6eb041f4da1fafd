// SPDX-License-Identifier: Apache-2.0
#include "study/paper/matching.h"

#include <cmath>
#include <cstring>
#include <map>
#include <memory>

#include "base/error.h"
#include "base/kernel_text.h"
#include "lab/measure/albedo.h"
#include "lab/measure/matching.h"

namespace lobe {
namespace {

class Measured {
  public:
    Measured(const Device& device, const KernelText& kernels)
        : device_(device), kernels_(kernels) {}

    double albedo(const std::string& model, double n) {
        const auto [place, fresh] = albedos_.try_emplace({model, n}, 0);
        if (!fresh) return place->second;
        BrdfProbe& probe = probe_of(model);
        probe.set_parameters({brdf_rows(probe.model(), {{"kd", 0}, {"ks", 1}, {"n", n}})});
        return place->second = directional_albedos(probe, {{0, {0, 0, 1}}}).front().value.x;
    }

    double equal_width(const std::string& model, double n) {
        const auto [place, fresh] = widths_.try_emplace({model, n}, 0);
        if (!fresh) return place->second;
        const Sharpened own = lobe_of(model), other = lobe_of("rational");
        const Match match = match_lobes(own, other, {n}).front();
        for (std::size_t c = 0; c < criteria.size(); ++c)
            if (std::strcmp(criteria[c].name, "half-width") == 0) place->second = match.matched[c];
        if (!(place->second > 0))
            throw Error(ExitCode::scene,
                        "no lobe of " + model +
                            " is as wide as the rational one "
                            "of n = " +
                            std::to_string(n),
                        "", "choose a larger n with --n");
        return place->second;
    }

  private:
    BrdfProbe& probe_of(const std::string& model) {
        auto& probe = probes_[model];
        const std::string file = "brdf/" + model + ".h";
        if (!probe)
            probe = std::make_unique<BrdfProbe>(
                device_, kernels_, parse_brdf_table(file, kernels_.read(file)),
                device_.info().fp64 ? Precision::twice : Precision::single);
        return *probe;
    }

    Sharpened lobe_of(const std::string& model) {
        BrdfProbe& probe = probe_of(model);
        return find_sharpness(probe, set_up(probe.model(), {{"", "kd", "0"}, {"", "ks", "1"}}),
                              "n");
    }

    const Device& device_;
    const KernelText& kernels_;
    std::map<std::string, std::unique_ptr<BrdfProbe>> probes_;
    std::map<std::pair<std::string, double>, double> albedos_, widths_;
};

}  // namespace

LobeMeasure measured_on(const Device& device, const KernelText& kernels) {
    const auto measured = std::make_shared<Measured>(device, kernels);
    return {
        [measured](const std::string& model, double n) { return measured->albedo(model, n); },
        [measured](const std::string& model, double n) { return measured->equal_width(model, n); }};
}

}  // namespace lobe
