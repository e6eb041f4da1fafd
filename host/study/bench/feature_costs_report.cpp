// SPDX-License-Identifier: Apache-2.0
#include "study/bench/feature_costs_report.h"

#include <cmath>

#include "base/format.h"
#include "base/statistics.h"
#include "report/text_table.h"

namespace lobe {
namespace {

using Json = nlohmann::ordered_json;

// Of one compilation; NaN below two, which say nothing of it.
double compile_deviation(const KernelCost& cost) {
    return cost.compiles.size() < 2 ? NAN : deviation_from(cost.compiles, median(cost.compiles));
}

std::string in_words(const KernelCost& cost) {
    switch (cost.render.verdict) {
        case Verdict::win:
            return "slower";
        case Verdict::loss:
            return "faster";
        case Verdict::tie:
            return "alike";
        case Verdict::undecided:
            return "undecided";
        case Verdict::refused:
            break;
    }
    return "not judged";
}

std::string kilobytes(const std::optional<std::size_t>& bytes) {
    return bytes ? formatted("%.1f", double(*bytes) / 1e3) : "unknown";
}

std::vector<std::string> compile_cells(const KernelCost& cost) {
    const double deviation = compile_deviation(cost);
    return {formatted("%.2f", median(cost.compiles)),
            std::isfinite(deviation) ? formatted("%.2f", deviation) : "unknown",
            kilobytes(cost.binary_bytes),
            cost.private_bytes ? std::to_string(*cost.private_bytes) : "unknown",
            formatted("%.2f", double(cost.device_bytes) / 1e6)};
}

std::vector<std::string> row(const std::string& name, const KernelCost& cost,
                             const std::vector<std::string>& render) {
    std::vector<std::string> cells = compile_cells(cost);
    cells.insert(cells.begin(), name);
    cells.insert(cells.end(), render.begin(), render.end());
    return cells;
}

template <typename T>
Json told(const std::optional<T>& value) {
    return value ? Json(*value) : Json();
}
Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json kernel_json(const KernelCost& cost) {
    return {{"name", cost.name},
            {"compile_cold_s", median(cost.compiles)},
            {"compile_cold_s_deviation", finite(compile_deviation(cost))},
            {"compiles", cost.compiles.size()},
            {"binary_bytes", told(cost.binary_bytes)},
            {"private_bytes", told(cost.private_bytes)},
            {"device_bytes", cost.device_bytes}};
}

Json more_json(const KernelCost& cost) {
    Json json = kernel_json(cost);
    const Judgement& j = cost.render;
    json["render_s"] = median(cost.renders);
    json["render_ratio"] = finite(j.ratio);
    json["render_ratio_ci95"] = {finite(j.lo), finite(j.hi)};
    json["render_timing_noise"] = finite(cost.timing_noise);
    json["verdict"] = in_words(cost);
    if (!j.reason.empty()) json["not_judged_because"] = j.reason;
    return json;
}

}  // namespace

std::string to_text(const FeatureCosts& costs, const DeviceInfo& device, const CostPlan& plan) {
    std::string text = "device  " + device.name + ", " + device.platform + "\n" +
                       formatted("film    %ux%u, %u samples a pixel, %u pairs of renders\n\n",
                                 costs.width, costs.height, plan.samples, plan.repeats);
    TextTable table({"kernel", "compile s", "+-", "binary kB", "private B", "device MB", "render",
                     "95 %", "is"});
    table.add(row("its own", costs.own, {"1"}));
    for (const KernelCost& cost : costs.more) {
        const Judgement& j = cost.render;
        table.add(row(
            "+ " + cost.name, cost,
            {formatted("%.3f", j.ratio), formatted("%.3f to %.3f", j.lo, j.hi), in_words(cost)}));
    }
    text += table.text() + "\n";
    for (const KernelCost& cost : costs.more)
        if (!cost.render.reason.empty())
            text += "not judged, " + cost.name + ": " + cost.render.reason + "\n";
    return text +
           "compile: cold, median, and the deviation of one. render: time over that with the\n"
           "scene's own kernel, geometric mean over pairs; slower and faster are by more than 2 "
           "%,\n"
           "certain over all rows together. unknown: the device does not tell, or it is of one\n"
           "alone. All kernels gave the same pictures to the bit.\n";
}

Json to_json(const FeatureCosts& costs, const DeviceInfo& device, const CostPlan& plan) {
    Json json = {{"device", device.name},
                 {"platform", device.platform},
                 {"driver", device.driver},
                 {"resolution", {costs.width, costs.height}},
                 {"spp", plan.samples},
                 {"repeats", plan.repeats},
                 {"image_hash", costs.image_hash},
                 {"own", kernel_json(costs.own)},
                 {"more", Json::array()}};
    for (const KernelCost& cost : costs.more) json["more"].push_back(more_json(cost));
    return json;
}

}  // namespace lobe
