// SPDX-License-Identifier: Apache-2.0
#include "report/drawing.h"

namespace lobe {

double text_width(const std::string& text, double size) {
    double width = 0;
    for (const char c : text) {
        const bool continues = (static_cast<unsigned char>(c) & 0xc0) == 0x80;  // of UTF-8
        if (!continues) width += c == ' ' || c == '.' || c == 'i' || c == 'l' ? 0.32 : 0.62;
    }
    return width * size;
}

double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 along = b - a;
    const double square = glm::dot(along, along);
    const double t = square > 0 ? glm::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0;
    return glm::distance(p, a + t * along);
}

std::vector<glm::dvec2> simplified(const std::vector<glm::dvec2>& points, double tolerance) {
    if (points.size() < 3) return points;
    std::vector<char> kept(points.size(), 0);
    kept.front() = kept.back() = 1;
    std::vector<std::pair<std::size_t, std::size_t>> open = {{0, points.size() - 1}};
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        std::size_t far = first;
        double most = tolerance;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double d = distance_to_segment(points[i], points[first], points[last]);
            if (d > most) {
                most = d;
                far = i;
            }
        }
        if (far == first) continue;
        kept[far] = 1;
        open.push_back({first, far});
        open.push_back({far, last});
    }
    std::vector<glm::dvec2> out;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (kept[i]) out.push_back(points[i]);
    return out;
}

}  // namespace lobe
