// SPDX-License-Identifier: Apache-2.0
#include "lab/page/model_page.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "base/error.h"
#include "base/luminance.h"
#include "lab/parameter_sweep.h"

namespace lobe {
namespace {

// Plain text with what Markdown would take for its own made harmless, but for `code`.
std::string markdown(const std::string& text) {
    std::string out;
    bool code = false;
    for (const char c : text) {
        if (c == '`') code = !code;
        if (!code && std::string("*_<>|[]\\").find(c) != std::string::npos) out += '\\';
        out += c;
    }
    return out;
}

// Lines of at most `width`, broken at spaces, each after `indent`.
std::string wrapped(const std::string& text, std::size_t width, const std::string& indent) {
    std::istringstream words(text);
    std::string out, line;
    for (std::string word; words >> word;) {
        if (!line.empty() && line.size() + 1 + word.size() > width) {
            out += indent + line + "\n";
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
    }
    return out + indent + line + "\n";
}

// The doc block's paragraphs, each on one line, without its first sentence.
std::vector<std::string> paragraphs(const BrdfTable& model) {
    std::vector<std::string> all(1);
    std::istringstream lines(model.doc);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty())
            all.emplace_back();
        else
            all.back() += (all.back().empty() ? "" : " ") + line;
    }
    all[0].erase(0, std::min(model.title().size(), all[0].size()));
    if (!all[0].empty() && all[0][0] == ' ') all[0].erase(0, 1);
    all.erase(std::remove(all.begin(), all.end(), ""), all.end());
    return all;
}

struct Title {
    std::string name, formula;
};

// "Phong: f = kd + ..." in two.
Title title_of(const BrdfTable& model) {
    const std::string title = model.title();
    const auto colon = title.find(": ");
    if (colon == std::string::npos) return {title, ""};
    return {title.substr(0, colon), title.substr(colon + 2)};
}

std::string doc_text(const BrdfTable& model) {
    const Title title = title_of(model);
    std::string out = "# " + markdown(title.name) + "\n\n";
    const bool equation = title.formula.find(" = ") != std::string::npos;
    if (equation) out += wrapped(title.formula, 88, "    ") + "\n";
    if (!equation && !title.formula.empty())
        out += wrapped(markdown(title.formula), 100, "") + "\n";
    for (std::string paragraph : paragraphs(model)) {
        std::string head;
        for (const char* label : {"Sources:", "Source:"})
            if (paragraph.compare(0, std::string(label).size(), label) == 0) {
                head = "**" + std::string(label) + "** ";
                paragraph.erase(0, std::string(label).size());
                break;
            }
        out += wrapped(head + markdown(paragraph), 100, "") + "\n";
    }
    return out;
}

std::string range_of(const BrdfParameter& p) {
    if (p.kind == BrdfParameterKind::table) return "";
    if (p.kind == BrdfParameterKind::choice) {
        std::string names;
        for (const std::string& name : p.choices) names += (names.empty() ? "" : ", ") + name;
        return names;
    }
    return short_number(p.lowest) + " to " +
           (std::isinf(p.highest) ? "inf" : short_number(p.highest));
}

// A choice's meaning begins with its names, which stand in a column of their own.
std::string meaning_of(const BrdfParameter& p) {
    const auto colon = p.meaning.find(": ");
    const bool named = p.kind == BrdfParameterKind::choice && colon != std::string::npos;
    return markdown(named ? p.meaning.substr(colon + 2) : p.meaning);
}

std::string parameter_table(const BrdfTable& model) {
    std::string out =
        "## Parameters\n\n| name | kind | default | range | meaning |\n|---|---|---|---|---|\n";
    const BrdfRows rows = model.default_rows();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const BrdfParameter& p = model.parameters[i];
        out += "| `" + p.name + "` | " + kind_name(p.kind) + " | " +
               (p.kind == BrdfParameterKind::table ? "" : value_text(p, rows[i])) + " | " +
               range_of(p) + " | " + meaning_of(p) + " |\n";
    }
    return out + "\n";
}

std::string claims_text(const BrdfClaims& claims) {
    const auto said = [](bool made, const char* what) {
        return std::string(made ? "is claimed to " : "is not claimed to ") + what;
    };
    return "The model " + said(claims.reciprocal, "be reciprocal") + ", " +
           said(claims.conserves_energy, "conserve energy") + " and " +
           said(claims.keeps_samples, "lose no sample") + " there.\n\n";
}

std::string digits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return std::isfinite(value) ? text : "";
}

std::string measured(const ModelPage& page) {
    const ModelTable& table = page.table;
    std::string out = "## Measured\n\nWith " + markdown(table.subject.text()) + ", on " +
                      markdown(page.device) + ".\n\n";
    out += claims_text(table.claims);
    out +=
        "| view | albedo | peak of f | at | half-width | least f |\n|---|---|---|---|---|---|\n"
        "| deg | | 1/sr | deg | deg | 1/sr |\n";
    for (const ViewRow& row : table.views) {
        const PlaneLobe& lobe = row.lobe;
        const std::optional<double> width = lobe.half_width();
        out += "| " + digits(row.degrees) + " | " + digits(luminance(row.albedo.value)) + " | " +
               digits(lobe.peak) + " | " + (lobe.any ? digits(glm::degrees(lobe.at)) : "") + " | " +
               (width ? digits(glm::degrees(*width)) : "") + " | " + digits(lobe.base) + " |\n";
    }
    return out +
           "\nPeak and least value are those in the plane of incidence, the peak at most 89 deg "
           "from the\nnormal; the half-width is the angle from the peak at which f has fallen "
           "halfway to "
           "the least.\n\n";
}

std::string check_table(const ModelPage& page) {
    if (page.checks.empty()) return "";
    std::string out = "## Checked\n\nBy `" + page.checked_by + "`.\n\n" +
                      "| check | verdict | found | remark |\n|---|---|---|---|\n";
    for (const CheckLine& line : page.checks)
        out += "| " + markdown(line.check) + " | " + line.verdict + " | " + markdown(line.found) +
               " | " + markdown(line.remark) + " |\n";
    return out + "\n";
}

// "worst 1e-7 of 96, limit 2e-6 (defaults at 45 deg)".
std::string found_text(bool statistical, double figure, double limit, std::size_t tests,
                       const std::string& where) {
    if (tests == 0) return "nothing to test";
    std::string text = (statistical ? "least p " : "worst ") + short_number(figure) + " of " +
                       std::to_string(tests);
    if (std::isfinite(limit)) text += ", limit " + short_number(limit);
    return where.empty() ? text : text + " (" + where + ")";
}

}  // namespace

std::vector<CheckLine> check_lines(const ModelReport& report) {
    std::vector<CheckLine> lines;
    for (const Finding& f : report.findings) {
        const bool statistical = !f.p.empty();
        const bool skipped = f.tests == 0 && !f.skipped.empty();
        lines.push_back({f.check,
                         skipped    ? "skip"
                         : f.passed ? "ok"
                                    : "FAIL",
                         found_text(statistical, statistical ? f.least_p() : f.worst, f.limit,
                                    f.tests, f.where),
                         skipped ? f.skipped : f.note});
    }
    return lines;
}

std::vector<CheckLine> check_lines(const nlohmann::json& file, const std::string& model,
                                   const std::string& where) {
    std::vector<CheckLine> lines;
    try {
        for (const auto& report : file.at("models")) {
            if (report.at("model") != model) continue;
            for (const auto& f : report.at("checks")) {
                const bool statistical = f.contains("least_p");
                const auto tests = f.at("tests").get<std::size_t>();
                const double figure = f.value(statistical ? "least_p" : "worst", 0.0);
                const std::string skipped = f.value("skipped", "");
                lines.push_back({f.at("check"), f.at("verdict"),
                                 found_text(statistical, figure, f.value("limit", NAN), tests,
                                            f.value("where", "")),
                                 skipped.empty() ? f.value("note", "") : skipped});
            }
        }
    } catch (const nlohmann::json::exception& fault) {
        throw Error(ExitCode::scene, std::string("no results of checks: ") + fault.what(), where,
                    "lobe brdf check all --json FILE writes some");
    }
    return lines;
}

std::string to_markdown(const ModelPage& page) {
    const BrdfTable& model = page.table.subject.model;
    std::string out = doc_text(model) + "Its file is `" + model.file + "`.\n\n";
    if (!page.polar.empty()) out += "![polar plot](" + page.polar + ")\n";
    if (!page.sphere.empty())
        out += "![rendered sphere](" + page.sphere +
               ")\n\nThe sphere: " + std::to_string(page.sphere_picture.samples) +
               " samples a pixel, error " + error_text(page.sphere_picture) + ".\n";
    out += "\n" + parameter_table(model) + measured(page) + check_table(page);
    while (out.size() > 1 && out[out.size() - 2] == '\n') out.pop_back();
    return out;
}

std::string index_page(const std::vector<BrdfTable>& models) {
    std::string out = "# Reflectance models\n\n| model | formula |\n|---|---|\n";
    for (const BrdfTable& model : models) {
        const Title title = title_of(model);
        out += "| [" + markdown(title.name) + "](" + model.name + ".md) | " +
               markdown(title.formula) + " |\n";
    }
    return out + "\nThese pages are written by `lobe brdf doc`.\n";
}

}  // namespace lobe
