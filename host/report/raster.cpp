// SPDX-License-Identifier: Apache-2.0
#include "report/raster.h"

#include <algorithm>
#include <cmath>

#include "base/log.h"
#include "report/font.h"
#include "report/image_io.h"

namespace lobe {
namespace {

// Paints by coverage: how much of a pixel lies within a shape, by its distance from the edge.
class Painter {
  public:
    Painter(ImageFile& image, double scale)
        : image_(image), scale_(scale), mask_(image.width * std::size_t(image.height)) {}

    void draw(const Area& area) {
        fill(area.points);
        paint(area.ink, area.opacity);
    }
    void draw(const Polyline& line) {
        stroke(simplified(line.points, 0.02), line.width);
        paint(line.ink);
    }
    void draw(const Dot& dot) {
        cover(dot.centre - dot.radius, dot.centre + dot.radius, [&](const glm::dvec2& p) {
            return (dot.radius - glm::distance(p, dot.centre)) * scale_ + 0.5;
        });
        paint(dot.ink);
    }

  private:
    // As SVG's nonzero rule has it: inside is where the outline turns around.
    static bool winds_around(const std::vector<glm::dvec2>& points, const glm::dvec2& p) {
        int turns = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::dvec2 a = points[i], b = points[(i + 1) % points.size()];
            if ((a.y <= p.y) == (b.y <= p.y)) continue;
            const double x = a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
            if (x > p.x) turns += b.y > a.y ? 1 : -1;
        }
        return turns != 0;
    }

    // The mean of 4x4 points a pixel.
    void fill(const std::vector<glm::dvec2>& points) {
        if (points.size() < 3) return;
        glm::dvec2 low = points[0], high = points[0];
        for (const glm::dvec2& p : points) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        cover(low, high, [&](const glm::dvec2& p) {
            int inside = 0;
            for (int i = 0; i < 16; ++i)
                inside += winds_around(points, p + (glm::dvec2(i % 4, i / 4) - 1.5) / 4.0 / scale_);
            return inside / 16.0;
        });
    }

    void stroke(const std::vector<glm::dvec2>& points, double width) {
        for (std::size_t i = 1; i < points.size(); ++i) {
            const glm::dvec2 a = points[i - 1], b = points[i];
            cover(glm::min(a, b) - width, glm::max(a, b) + width, [&](const glm::dvec2& p) {
                return (width / 2 - distance_to_segment(p, a, b)) * scale_ + 0.5;
            });
        }
    }

    // Raises the mask to `coverage` at the pixels of a box and one around.
    template <typename Coverage>
    void cover(const glm::dvec2& low, const glm::dvec2& high, const Coverage& coverage) {
        const auto bound = [](double v, std::uint32_t most) {
            return static_cast<std::uint32_t>(glm::clamp(v, 0.0, static_cast<double>(most)));
        };
        const std::uint32_t x0 = bound(low.x * scale_ - 1, image_.width);
        const std::uint32_t x1 = bound(high.x * scale_ + 2, image_.width);
        const std::uint32_t y0 = bound(low.y * scale_ - 1, image_.height);
        const std::uint32_t y1 = bound(high.y * scale_ + 2, image_.height);
        for (std::uint32_t y = y0; y < y1; ++y)
            for (std::uint32_t x = x0; x < x1; ++x) {
                const double part = coverage((glm::dvec2(x, y) + 0.5) / scale_);
                float& at = mask_[y * std::size_t(image_.width) + x];
                at = std::max(at, static_cast<float>(std::min(part, 1.0)));
            }
    }

    void paint(const Ink& ink, double opacity = 1) {
        const float colour[3] = {float(ink.red), float(ink.green), float(ink.blue)};
        for (std::size_t i = 0; i < mask_.size(); ++i) {
            if (mask_[i] <= 0) continue;
            for (std::size_t c = 0; c < 3; ++c) {
                float& at = image_.pixels[3 * i + c];
                at += mask_[i] * static_cast<float>(opacity) * (colour[c] - at);
            }
            mask_[i] = 0;
        }
    }

    ImageFile& image_;
    double scale_;
    std::vector<float> mask_;
};

// Texts in units of pixels.
std::vector<Text> scaled(std::vector<Text> texts, double scale) {
    for (Text& text : texts) {
        text.at *= scale;
        text.size *= scale;
    }
    return texts;
}

}  // namespace

ImageFile rasterise(const Drawing& drawing, ImageIo& images, double scale) {
    ImageFile image;
    image.width = image.full_width = static_cast<std::uint32_t>(std::ceil(drawing.width * scale));
    image.height = image.full_height =
        static_cast<std::uint32_t>(std::ceil(drawing.height * scale));
    image.channels = {"R", "G", "B"};
    image.bytes = true;
    image.pixels.assign(3 * std::size_t(image.width) * image.height, 255);
    Painter painter(image, scale);
    for (const Area& area : drawing.areas) painter.draw(area);
    for (const Polyline& line : drawing.lines) painter.draw(line);
    for (const Dot& dot : drawing.dots) painter.draw(dot);
    if (!drawing.texts.empty()) {
        const std::string font = find_font();
        if (font.empty())
            warn("no font is found: the picture has no labels (install fonts-dejavu-core)");
        else
            images.draw_texts(image, font, scaled(drawing.texts, scale));
    }
    for (float& value : image.pixels) value = std::floor(glm::clamp(value, 0.0f, 255.0f) + 0.5f);
    return image;
}

}  // namespace lobe
