// SPDX-License-Identifier: Apache-2.0
#include "study/paper/claims.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>

#include "base/kernel_text.h"
#include "lab/brdf_probe.h"

namespace lobe {
namespace {

// Times that differ by less are equal.
constexpr double equal_times = 0.05;

std::string interval_text(const RatioInterval& r) {
    char text[80];
    std::snprintf(text, sizeof text, "%.3f (%.3f to %.3f)", r.ratio, r.lo, r.hi);
    return text;
}

const FootingFindings& at(const PaperFindings& findings, std::size_t footing, std::size_t sampler) {
    return findings.footings[footing * paper_samplers.size() + sampler];
}

Claim equal_time(const PaperFindings& findings) {
    Claim claim{"equal_time", "the three models take equal time"};
    const auto& against = at(findings, 0, cosine_sampler).against;
    bool within = true, outside = false;
    double noise = 0;
    for (std::size_t model = 0; model < 3; ++model)
        noise = std::max(noise, findings.cells[model][cosine_sampler].timing_noise);
    for (const AgainstRational& other : against) {
        within = within && other.time.lo > 1 - equal_times && other.time.hi < 1 + equal_times;
        outside = outside || other.time.hi < 1 - equal_times || other.time.lo > 1 + equal_times;
    }
    claim.holds = within ? Holds::yes : outside ? Holds::no : Holds::undecided;
    if (!(noise < most_timing_noise)) claim.holds = Holds::undecided;  // a busy machine
    claim.figures = "time over Phong's " + interval_text(against[0].time) + ", modified Phong's " +
                    interval_text(against[1].time) + "; within 5 % is equal; times vary by " +
                    std::to_string(std::lround(100 * noise)) + " %";
    return claim;
}

Claim lower_error(const PaperFindings& findings) {
    Claim claim{"lower_error", "the rational model's error is below Phong's and modified Phong's"};
    std::size_t held = 0, failed = 0;
    for (const FootingFindings& found : findings.footings) {
        if (found.holds() == Holds::no) ++failed;
        if (found.holds() != Holds::yes) continue;
        ++held;
        claim.condition += (claim.condition.empty() ? "" : "; ") +
                           std::string(to_text(found.footing)) + ", " +
                           paper_samplers[found.sampler].name;
    }
    claim.holds = held == findings.footings.size() ? Holds::yes
                  : held                           ? Holds::only_if
                  : failed                         ? Holds::no
                                                   : Holds::undecided;
    if (claim.holds != Holds::only_if) claim.condition.clear();
    for (std::size_t k = 0; k < footings.size(); ++k) {
        const auto& against = at(findings, k, cosine_sampler).against;
        char text[120];
        std::snprintf(text, sizeof text, "%s%s %.3f, %.3f",
                      k ? "; " : "error over theirs, cosine: ", to_text(footings[k]),
                      against[0].rmse.ratio, against[1].rmse.ratio);
        claim.figures += text;
    }
    return claim;
}

}  // namespace

std::string to_text(Holds holds) {
    switch (holds) {
        case Holds::yes:
            return "HOLDS";
        case Holds::no:
            return "DOES NOT HOLD";
        case Holds::only_if:
            return "HOLDS ONLY IF";
        case Holds::undecided:
            break;
    }
    return "UNDECIDED";
}

LobeValues lobe_values_on(const Device& device, const KernelText& kernels) {
    const auto probes = std::make_shared<std::map<std::string, std::unique_ptr<BrdfProbe>>>();
    return
        [=, &device, &kernels](const LobeVariant& lobe, const std::vector<DirectionsPair>& pairs) {
            auto& probe = (*probes)[lobe.model];
            const std::string file = "brdf/" + lobe.model + ".h";
            if (!probe)
                probe = std::make_unique<BrdfProbe>(
                    device, kernels, parse_brdf_table(file, kernels.read(file)),
                    device.info().fp64 ? Precision::twice : Precision::single);
            std::vector<std::pair<std::string, double>> rows = {
                {"kd", 0}, {"ks", 1}, {"n", lobe.n}, {"normalize", lobe.normalize}};
            if (lobe.reading) rows.emplace_back("lobe", lobe.reading);
            probe->set_parameters({brdf_rows(probe->model(), rows)});
            BrdfQuery query;
            for (const DirectionsPair& pair : pairs) query.add(0, pair.wo, pair.wi);
            std::vector<double> f;
            for (const BrdfValue& value : probe->eval(query)) f.push_back(value.f.x);
            for (std::size_t i = 0; i < f.size(); ++i) f[i] /= pairs[i].wi.z;
            return f;
        };
}

std::vector<Claim> judge_experiment_claims(const PaperExperiment& experiment,
                                           const PaperFindings& findings) {
    if (experiment.rounds >= 2) return {equal_time(findings), lower_error(findings)};
    Claim time{"equal_time", "the three models take equal time"};
    Claim error{"lower_error", "the rational model's error is below Phong's and modified Phong's"};
    time.figures = error.figures = "fewer than two complete runs";
    return {time, error};
}

}  // namespace lobe
