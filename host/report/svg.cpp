// SPDX-License-Identifier: Apache-2.0
#include "report/svg.h"

#include <cmath>
#include <cstdio>

#include "report/markup.h"

namespace lobe {
namespace {

// Two digits after the point, and none that say nothing.
std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", value);
    std::string out = text;
    out.erase(out.find_last_not_of('0') + 1);
    if (out.back() == '.') out.pop_back();
    return out == "-0" ? "0" : out;
}

std::string attribute(const char* name, const std::string& value) {
    return std::string(" ") + name + "=\"" + value + "\"";
}

std::string attribute(const char* name, double value) { return attribute(name, number(value)); }

std::string colour(const Ink& ink) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", ink.red, ink.green, ink.blue);
    return text;
}

std::string list(const std::vector<glm::dvec2>& points) {
    std::string text;
    for (const glm::dvec2& p : points)
        text += (text.empty() ? "" : " ") + number(p.x) + "," + number(p.y);
    return text;
}

struct Writer {
    std::string out;

    void write(const Area& area) {
        out += "<polygon" + attribute("points", list(area.points)) +
               attribute("fill", colour(area.ink));
        if (area.opacity < 1) out += attribute("fill-opacity", area.opacity);
        out += "/>\n";
    }
    void write(const Polyline& line) {
        out +=
            "<polyline fill=\"none\"" + attribute("points", list(simplified(line.points, 0.05))) +
            attribute("stroke", colour(line.ink)) + attribute("stroke-width", line.width) + "/>\n";
    }
    void write(const Dot& dot) {
        out += "<circle" + attribute("cx", dot.centre.x) + attribute("cy", dot.centre.y) +
               attribute("r", dot.radius) + attribute("fill", colour(dot.ink)) + "/>\n";
    }
    void write(const Text& text) {
        static const char* const anchors[] = {"start", "middle", "end"};
        out += "<text" + attribute("x", text.at.x) + attribute("y", text.at.y) +
               attribute("fill", colour(text.ink)) + attribute("font-size", text.size);
        if (text.anchor != Anchor::start)
            out += attribute("text-anchor", anchors[static_cast<int>(text.anchor)]);
        out += ">" + markup_text(text.text) + "</text>\n";
    }
};

}  // namespace

std::string to_svg(const Drawing& drawing) {
    const std::string width = number(drawing.width), height = number(drawing.height);
    Writer writer;
    writer.out = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", width) +
                 attribute("height", height) + attribute("viewBox", "0 0 " + width + " " + height) +
                 " font-family=\"DejaVu Sans, Verdana, sans-serif\" stroke-linejoin=\"round\"" +
                 " stroke-linecap=\"round\">\n<title>" + markup_text(drawing.title) + "</title>\n" +
                 "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    for (const Area& area : drawing.areas) writer.write(area);
    for (const Polyline& line : drawing.lines) writer.write(line);
    for (const Dot& dot : drawing.dots) writer.write(dot);
    // A rim of the paper's colour keeps text readable where it crosses a line.
    writer.out += "<g stroke=\"#fff\" stroke-width=\"3\" style=\"paint-order:stroke\">\n";
    for (const Text& text : drawing.texts) writer.write(text);
    return writer.out + "</g>\n</svg>\n";
}

}  // namespace lobe
