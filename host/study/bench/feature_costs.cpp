// SPDX-License-Identifier: Apache-2.0
#include "study/bench/feature_costs.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/format.h"
#include "base/progress.h"
#include "base/statistics.h"

namespace lobe {
namespace {

double variation(const std::vector<double>& values) {
    return std::sqrt(sample_variance(values)) / mean(values);
}

// Why the ratios are not to be judged, or "".
std::string refusal(const PairedRatios& ratios, double noise) {
    if (ratios.log_ratios.size() < least_seeds)
        return formatted("fewer than %u repeats", least_seeds);
    if (noise > most_timing_noise)
        return formatted("times vary by %.0f %%: a busy machine, or too few samples", 100 * noise);
    return "";
}

class Measurement {
  public:
    Measurement(const Device& device, const KernelText& kernels, const Scene& scene,
                const CostPlan& plan, const std::function<bool()>& stop)
        : device_(device), kernels_(kernels), scene_(scene), plan_(plan), stop_(stop) {}

    std::optional<FeatureCosts> run(const PackOptions& own_pack) {
        Arm own("its own", device_, kernels_, scene_, own_pack);
        const std::vector<KernelVariant> variants = kernel_variants(scene_, own_pack);
        total_ = plan_.compiles + double(variants.size()) * (plan_.compiles + 1 + plan_.repeats);
        costs_.width = own.width();
        costs_.height = own.height();
        costs_.own.name = own.name();
        if (!compile(own, costs_.own, plan_.compiles)) return {};
        costs_.own.device_bytes = own.device_bytes();
        const ArmRun first = own.run(first_seed, plan_.samples, stop_);
        if (first.stopped) return {};
        costs_.image_hash = image_hash(first.picture);
        for (const KernelVariant& variant : variants)
            if (!measure(own, variant)) return {};
        judge_all();
        return costs_;
    }

  private:
    static constexpr std::uint64_t first_seed = 1;

    bool measure(Arm& own, const KernelVariant& variant) {
        Arm arm(variant.name, device_, kernels_, scene_, variant.pack);
        KernelCost cost;
        cost.name = variant.name;
        cost.device_bytes = arm.device_bytes();
        // The own kernel once more beside each: so its spread tells of what drifts meanwhile.
        if (!compile(own, costs_.own, 1) || !compile(arm, cost, plan_.compiles)) return false;
        std::vector<double> own_renders;
        for (unsigned i = 0; i < plan_.repeats; ++i) {
            const bool own_first = i % 2 == 0;
            reopen(own_first ? own : arm, own_first ? arm : own);
            std::optional<ArmRun> a, b;
            if (own_first) a = render(own, i);
            b = render(arm, i);
            if (!own_first) a = render(own, i);
            if (!a || !b) return false;
            check_alike(own, *a, arm, *b);
            own_renders.push_back(a->seconds);
            cost.renders.push_back(b->seconds);
            cost.ratios.log_ratios.push_back(std::log(b->seconds / a->seconds));
            show(1, variant.name);
        }
        cost.timing_noise = std::max(variation(own_renders), variation(cost.renders));
        cost.ratios.refusal = refusal(cost.ratios, cost.timing_noise);
        costs_.more.push_back(std::move(cost));
        return true;
    }

    // How fast sessions are depends on where their memory lies: every repeat has new ones.
    void reopen(Arm& first, Arm& second) {
        for (Arm* arm : {&first, &second}) arm->close();
        for (Arm* arm : {&first, &second}) arm->reopen();
    }

    std::optional<ArmRun> render(Arm& arm, unsigned repeat) {
        arm.run(first_seed + repeat, 1, stop_);  // warms up
        if (stopped()) return {};
        ArmRun run = arm.run(first_seed + repeat, plan_.samples, stop_);
        if (run.stopped) return {};
        return run;
    }

    bool compile(const Arm& arm, KernelCost& cost, unsigned times) {
        for (unsigned i = 0; i < times; ++i) {
            if (stopped()) return false;
            const auto session = arm.open_again(Caches::none);
            cost.compiles.push_back(session->compile_seconds());
            if (cost.compiles.size() == 1) {
                cost.private_bytes = session->private_bytes();
                cost.binary_bytes = session->binary_bytes();
            }
            show(1, arm.name());
        }
        return true;
    }

    void check_alike(const Arm& own, const ArmRun& a, const Arm& arm, const ArmRun& b) const {
        if (image_hash(a.picture) == image_hash(b.picture)) return;
        throw Error(ExitCode::comparison,
                    "with " + arm.name() + " compiled in the picture differs from that of " +
                        own.name() + " kernel: a fault of lobe",
                    scene_.path);
    }

    void judge_all() {
        std::vector<PairedRatios> ratios;
        for (const KernelCost& cost : costs_.more) ratios.push_back(cost.ratios);
        const std::vector<Judgement> judgements = judge(ratios);
        for (std::size_t i = 0; i < judgements.size(); ++i) costs_.more[i].render = judgements[i];
    }

    bool stopped() const { return stop_ && stop_(); }
    void show(double done, const std::string& name) {
        done_ += done;
        shown_.update(done_, total_, name);
    }

    const Device& device_;
    const KernelText& kernels_;
    const Scene& scene_;
    const CostPlan& plan_;
    const std::function<bool()>& stop_;
    FeatureCosts costs_;
    double done_ = 0, total_ = 0;  // compilations and pairs of renders
    Progress shown_{"measure", "runs"};
};

}  // namespace

std::vector<KernelVariant> kernel_variants(const Scene& scene, const PackOptions& own) {
    std::vector<KernelVariant> variants;
    if (own.all_features) return variants;
    FeatureSet in = derive_features(scene);
    for (const Feature feature : own.forced) force(in, feature);
    for (std::size_t i = 0; i < in.size(); ++i) {
        if (in[i].in) continue;
        variants.push_back({in[i].name, own});
        variants.back().pack.forced.push_back(static_cast<Feature>(i));
    }
    const bool features = !variants.empty();
    const bool models = models_in_use(scene).size() < own.models.size();
    if (models) {
        variants.push_back({"all models", own});
        variants.back().pack.all_models = true;
    }
    if (features && (models || variants.size() > 1)) {
        variants.push_back({"everything", own});
        variants.back().pack.all_features = true;
    }
    return variants;
}

std::optional<FeatureCosts> measure_feature_costs(const Device& device, const KernelText& kernels,
                                                  const Scene& scene, const PackOptions& own,
                                                  const CostPlan& plan,
                                                  const std::function<bool()>& stop) {
    return Measurement(device, kernels, scene, plan, stop).run(own);
}

}  // namespace lobe
