// SPDX-License-Identifier: Apache-2.0
#include "study/bench/growth_report.h"

#include "base/format.h"
#include "report/chart/line_chart.h"
#include "report/text_table.h"
#include "study/page_parts.h"

namespace lobe {
namespace {

using Value = double (*)(const GrowthPoint&);

ChartSeries curve(const GrowthSeries& series, const std::string& label, Value value) {
    ChartSeries curve;
    curve.label = label;
    for (const GrowthPoint& p : series.points)
        curve.points.push_back({static_cast<double>(p.size), value(p)});
    return curve;
}

std::vector<std::string> head_of(const GrowthSeries& series) {
    return {series.what, "build s", "render s", "ns a sample", "device MB", "host MB at most"};
}

std::vector<std::string> row_of(const GrowthPoint& p) {
    return {std::to_string(p.size),
            formatted("%.3g", p.build_seconds),
            formatted("%.3g", p.render_seconds),
            formatted("%.4g", 1e9 * p.seconds_per_sample),
            formatted("%.4g", 1e-6 * static_cast<double>(p.device_bytes)),
            formatted("%.4g", 1e-6 * static_cast<double>(p.host_bytes))};
}

}  // namespace

std::string to_text(const std::vector<GrowthSeries>& growth) {
    std::string text;
    for (const GrowthSeries& series : growth) {
        TextTable table(head_of(series));
        for (const GrowthPoint& p : series.points) table.add(row_of(p));
        text += (text.empty() ? "" : "\n") + table.text();
        if (!series.end.empty()) text += "no more: " + series.end + "\n";
    }
    return text;
}

nlohmann::ordered_json to_json(const std::vector<GrowthSeries>& growth) {
    auto all = nlohmann::ordered_json::array();
    for (const GrowthSeries& series : growth) {
        auto points = nlohmann::ordered_json::array();
        for (const GrowthPoint& p : series.points)
            points.push_back({{"size", p.size},
                              {"build_s", p.build_seconds},
                              {"render_s", p.render_seconds},
                              {"s_per_sample", p.seconds_per_sample},
                              {"device_bytes", p.device_bytes},
                              {"host_bytes", p.host_bytes}});
        all.push_back({{"what", series.what}, {"points", points}, {"end", series.end}});
    }
    return all;
}

ReportSection growth_section(const GrowthSeries& series) {
    ReportSection section;
    section.heading = "What grows with " + series.what;
    LineChart time{"Time of a sample", series.what, "nanoseconds", {}};
    time.series = {
        curve(series, "", [](const GrowthPoint& p) { return 1e9 * p.seconds_per_sample; })};
    LineChart build{"Time to build hierarchies", series.what, "seconds", {}};
    build.series = {curve(series, "", [](const GrowthPoint& p) { return p.build_seconds; })};
    LineChart memory{"Memory", series.what, "MB", {}};
    memory.series = {
        curve(series, "device", [](const GrowthPoint& p) { return 1e-6 * double(p.device_bytes); }),
        curve(series, "host, at most",
              [](const GrowthPoint& p) { return 1e-6 * double(p.host_bytes); })};
    section.figures = {
        {draw(time), "Rendering alone, over pixels and samples; the median of three renders."},
        {draw(build), "From the scene in memory to all that the device needs."},
        {draw(memory),
         "The device's buffers, and the most that the process held; a CPU that is "
         "the device has its buffers in the process."}};
    ReportTable table;
    table.title = "The same in figures";
    table.head = head_of(series);
    for (const GrowthPoint& p : series.points) table.rows.push_back(row_of(p));
    if (!series.end.empty()) table.note = "No more: " + series.end;
    section.tables = {table};
    return section;
}

}  // namespace lobe
