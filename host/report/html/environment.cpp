// SPDX-License-Identifier: Apache-2.0
#include "report/html/parts.h"
#include "report/markup.h"
#include "report/way_on.h"

namespace lobe {
namespace {

ReportTable features_table(const ReportKernel& kernel) {
    ReportTable table;
    table.title = "What the kernel holds" + (kernel.name.empty() ? "" : ": " + kernel.name);
    table.head = {"Feature", "Meaning", "Compiled", "Because"};
    for (const bool in : {true, false})
        for (const FeatureState& f : kernel.features)
            if (f.in == in) table.rows.push_back({f.name, f.meaning, in ? "in" : "out", f.reason});
    for (const std::string& model : kernel.models)
        table.note += (table.note.empty() ? "BRDFs compiled in: " : ", ") + model;
    return table;
}

}  // namespace

std::string environment_html(const ReportEnvironment& e) {
    ReportFacts facts;
    const auto add = [&](const char* name, const std::string& value) {
        if (!value.empty()) facts.emplace_back(name, value);
    };
    if (!e.device.name.empty()) add("Device", e.device.name);
    if (e.device.compute_units)
        add("Compute units",
            std::to_string(e.device.compute_units) +
                (e.device.clock_mhz ? " at " + std::to_string(e.device.clock_mhz) + " MHz" : ""));
    add("Platform", e.device.platform);
    add("Driver", e.device.driver);
    add("lobe", e.version);
    add("Seed", e.seed);
    facts.insert(facts.end(), e.more.begin(), e.more.end());
    std::string out = facts_html(facts);
    if (!e.command.empty())
        out += "<p class=\"label\">Exact command</p>\n<pre>" +
               markup_text(command_text(e.command)) + "</pre>\n";
    for (const ReportKernel& kernel : e.kernels) out += table_html(features_table(kernel));
    return out;
}

}  // namespace lobe
