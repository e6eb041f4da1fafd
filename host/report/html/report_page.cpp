// SPDX-License-Identifier: Apache-2.0
#include "report/html/report_page.h"

#include "base/sha256.h"
#include "report/html/base64.h"
#include "report/html/parts.h"
#include "report/markup.h"
#include "report/svg.h"

namespace lobe {

std::string element(const std::string& name, const std::string& text) {
    return "<" + name + ">" + markup_text(text) + "</" + name + ">\n";
}

std::string facts_html(const ReportFacts& facts) {
    if (facts.empty()) return "";
    std::string out = "<dl>\n";
    for (const auto& [name, value] : facts) out += element("dt", name) + element("dd", value);
    return out + "</dl>\n";
}

namespace {

std::string bytes_of_hex(const std::string& hex) {
    std::string bytes;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
        bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
    return bytes;
}

// Whatever a text in the page may hold: the browser loads nothing and runs this one script only.
std::string head_html(const std::string& title) {
    const std::string digest = base64(bytes_of_hex(sha256(page_script)));
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
           "img-src data:; style-src 'unsafe-inline'; script-src 'sha256-" +
           digest +
           "'\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<meta name=\"color-scheme\" content=\"light dark\">\n"
           "<link rel=\"icon\" href=\"data:,\">\n" +
           element("title", title) + "<style>" + page_style + "</style>\n</head>\n";
}

std::string section_html(const ReportSection& section, const std::string& id, ImageIo& images) {
    std::string out = "<section id=\"" + id + "\">\n" + element("h2", section.heading);
    for (const std::string& paragraph : section.paragraphs) out += element("p", paragraph);
    out += facts_html(section.facts);
    for (const ReportFigure& figure : section.figures) {
        out += "<figure class=\"chart\">" + to_svg(figure.drawing);
        if (!figure.caption.empty()) out += element("figcaption", figure.caption);
        out += "</figure>\n";
    }
    for (const ReportTable& table : section.tables) out += table_html(table);
    for (const ReportViewer& viewer : section.viewers) out += viewer_html(viewer, images);
    return out + "</section>\n";
}

std::string contents_html(const ReportPage& page) {
    std::string out = "<nav aria-label=\"Contents\">";
    for (std::size_t i = 0; i < page.sections.size(); ++i)
        out += "<a href=\"#section" + std::to_string(i + 1) + "\">" +
               markup_text(page.sections[i].heading) + "</a> ";
    return out + "<a href=\"#conditions\">Conditions</a></nav>\n";
}

}  // namespace

std::string to_html(const ReportPage& page, ImageIo& images) {
    std::string out = head_html(page.title) + "<body>\n<main>\n<header>\n" +
                      element("h1", page.title) + "<p class=\"headline\">" +
                      markup_text(page.headline) + "</p>\n" + table_html(page.table) +
                      (page.sections.size() > 1 ? contents_html(page) : "") + "</header>\n";
    for (std::size_t i = 0; i < page.sections.size(); ++i)
        out += section_html(page.sections[i], "section" + std::to_string(i + 1), images);
    return out + "<section id=\"conditions\">\n" + element("h2", "Conditions") +
           environment_html(page.environment) + "</section>\n</main>\n<script>" + page_script +
           "</script>\n</body>\n</html>\n";
}

}  // namespace lobe
