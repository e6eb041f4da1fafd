// SPDX-License-Identifier: Apache-2.0
#include "study/page_parts.h"

#include <cmath>
#include <cstdio>
#include <sstream>

#include "report/chart/bar_chart.h"

namespace lobe {

std::string shown(double value, const char* format) {
    if (!std::isfinite(value)) return "-";
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string shown(const Interval& interval, const char* format) {
    if (!std::isfinite(interval.low) || !std::isfinite(interval.high)) return "-";
    return shown(interval.low, format) + " to " + shown(interval.high, format);
}

std::string exact(double value) { return std::isfinite(value) ? shown(value, "%.9g") : ""; }

std::vector<std::vector<std::string>> csv_rows(const std::string& csv) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(csv);
    for (std::string line; std::getline(lines, line);) {
        rows.push_back({""});
        bool quoted = false;
        for (std::size_t i = 0; i < line.size(); ++i) {
            if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
                rows.back().back() += line[i++];
            else if (line[i] == '"')
                quoted = !quoted;
            else if (line[i] == ',' && !quoted)
                rows.back().emplace_back();
            else if (line[i] != '\r')
                rows.back().back() += line[i];
        }
    }
    return rows;
}

void add_costs(ReportSection& section, const std::string& title,
               const std::vector<NamedCosts>& costs) {
    BarChart chart{title, "seconds", {"parse", "BVH", "compile", "upload", "render"}, {}};
    ReportTable table;
    table.title = title + ", seconds";
    table.head = {"", "parse", "BVH", "compile", "upload", "render", "total", "compiled"};
    table.csv = {
        {"name", "parse_s", "bvh_s", "compile_s", "upload_s", "render_s", "total_s", "compiled"}};
    for (const NamedCosts& c : costs) {
        const StartUp& s = c.start_up;
        std::vector<double> steps = {s.parse, s.bvh, s.compile, s.upload, c.render};
        chart.bars.push_back({c.name, steps});
        steps.push_back(s.total() + c.render);
        std::vector<std::string> cells = {c.name}, digits = {c.name};
        for (const double seconds : steps) {
            cells.push_back(shown(seconds, "%.3f"));
            digits.push_back(exact(seconds));
        }
        for (auto* row : {&cells, &digits})
            row->emplace_back(s.compiled_from_cache ? "before, from the cache" : "now");
        table.rows.push_back(cells);
        table.csv.push_back(digits);
    }
    section.figures.push_back({draw(chart), ""});
    section.tables.push_back(table);
}

std::string seed_range(std::uint64_t first, std::uint64_t last) {
    return std::to_string(first) + " to " + std::to_string(last);
}

}  // namespace lobe
