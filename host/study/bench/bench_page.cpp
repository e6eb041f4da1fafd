// SPDX-License-Identifier: Apache-2.0
#include "study/bench/bench_page.h"

#include <cmath>

#include "base/format.h"
#include "report/chart/bar_chart.h"
#include "study/bench/growth_report.h"
#include "study/page_parts.h"

namespace lobe {
namespace {

std::string rate(double value, double deviation) {
    return formatted("%.3g \xC2\xB1 %.1g", 1e-6 * value, 1e-6 * deviation);
}

ReportTable scene_table(const BenchReport& report) {
    ReportTable table;
    table.title = "Scenes";
    table.head = {"scene",          "Msamples/s",
                  "error",          "s to " + shown(100 * report.plan.target) + " %",
                  "compile cold s", "warm s",
                  "device MB"};
    for (const BenchScene& s : report.scenes)
        table.rows.push_back({s.name, rate(s.rate, s.rate_deviation),
                              formatted("%.3g %%", 100 * s.relative_error), shown(s.target_seconds),
                              shown(s.compile_cold), shown(s.compile_warm),
                              formatted("%.4g", 1e-6 * double(s.device_bytes))});
    table.note = "Medians of " + std::to_string(report.plan.repeats) +
                 " renders after one that warms up, with the spread of one of them; the error is "
                 "the picture's relative standard error, the time to the target as if it fell with "
                 "the root of time.";
    return table;
}

ReportSection ray_section(const BenchReport& report) {
    ReportSection section;
    section.heading = "Rays";
    for (const BenchScene& s : report.scenes) {
        ReportTable table;
        table.title = s.name;
        table.head = {"rays", "count", "met", "Mrays/s"};
        for (const RayRate& r : s.rays)
            table.rows.push_back({r.name, std::to_string(r.rays), formatted("%.0f %%", 100 * r.met),
                                  rate(r.rate, r.rate_deviation)});
        section.tables.push_back(table);
    }
    return section;
}

ReportSection start_section(const BenchReport& report) {
    ReportSection section;
    section.heading = "Start";
    std::vector<NamedCosts> costs;
    for (const BenchScene& s : report.scenes) {
        StartUp start = s.start_up;
        start.compile = s.compile_cold;
        costs.push_back({s.name, start, s.width * double(s.height) * s.samples / s.rate});
    }
    add_costs(section, "From the command to a picture, compiled for the first time", costs);
    return section;
}

}  // namespace

ReportPage bench_page(const BenchReport& report) {
    ReportPage page;
    page.title = "lobe on " + report.device.name;
    if (!report.scenes.empty()) {
        const BenchScene& s = report.scenes.front();
        page.headline = formatted(
            "%.3g million samples a second in %s; an error of %g %% there "
            "takes about %.3g s.",
            1e-6 * s.rate, s.name.c_str(), 100 * report.plan.target, s.target_seconds);
        page.table = scene_table(report);
        page.sections = {ray_section(report), start_section(report)};
    }
    for (const GrowthSeries& series : report.growth)
        page.sections.push_back(growth_section(series));
    page.environment.version = report.version;
    page.environment.device = report.device;
    page.environment.seed = seed_range(0, report.plan.repeats);
    page.environment.command = report.command;
    for (const BenchScene& s : report.scenes)
        page.environment.more.emplace_back("Content hash of " + s.name, s.content_hash);
    return page;
}

}  // namespace lobe
