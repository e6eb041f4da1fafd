// SPDX-License-Identifier: Apache-2.0
#include "report/html/costs.h"

#include <cstdio>

#include "report/chart/bar_chart.h"

namespace lobe {
namespace {

std::string digits(double value, const char* format) {
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

}  // namespace

ReportSection cost_section(const std::vector<RunCosts>& runs) {
    ReportSection section;
    section.heading = "Where the time goes";
    BarChart chart{"Time of each step", "seconds", {}, {}};
    chart.parts = {"parse", "BVH", "compile", "upload", "render", "write"};
    ReportTable table;
    table.title = "Seconds of each step";
    table.head = {"Run", "parse", "BVH", "compile", "upload", "render", "write", "total"};
    table.csv = {
        {"run", "parse_s", "bvh_s", "compile_s", "upload_s", "render_s", "write_s", "total_s"}};
    for (const RunCosts& run : runs) {
        const RenderTimes& s = run.seconds;
        const std::vector<double> parts = {s.parse, s.bvh, s.compile, s.upload, s.render, s.write};
        chart.bars.push_back({run.name, parts});
        std::vector<std::string> shown = {run.name}, exact = {run.name};
        for (const double value : parts) {
            shown.push_back(digits(value, "%.3f"));
            exact.push_back(digits(value, "%.9g"));
        }
        shown.push_back(digits(s.total, "%.3f"));
        exact.push_back(digits(s.total, "%.9g"));
        table.rows.push_back(shown);
        table.csv.push_back(exact);
    }
    section.figures.push_back({draw(chart), ""});
    section.tables.push_back(table);
    return section;
}

}  // namespace lobe
