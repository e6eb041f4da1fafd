// SPDX-License-Identifier: Apache-2.0
#include "lab/plot/plot_sphere.h"

#include <algorithm>

#include "report/chart/plot_style.h"
#include "report/raster.h"

namespace lobe {
namespace {

constexpr double margin = 12, caption = 44;
constexpr std::size_t columns = 4;

void paste(ImageFile& sheet, const ImageFile& picture, std::size_t x, std::size_t y) {
    for (std::size_t row = 0; row < picture.height; ++row)
        std::copy_n(&picture.pixels[3 * row * picture.width], 3 * std::size_t(picture.width),
                    &sheet.pixels[3 * ((y + row) * sheet.width + x)]);
}

}  // namespace

ImageFile sphere_sheet(const std::vector<SphereTile>& tiles, ImageIo& images) {
    const double width = tiles[0].picture.width, height = tiles[0].picture.height;
    const std::size_t across = std::min(columns, tiles.size());
    const std::size_t down = (tiles.size() + columns - 1) / columns;
    Drawing drawing;
    drawing.width = margin + static_cast<double>(across) * (width + margin);
    drawing.height = margin + static_cast<double>(down) * (height + caption);
    const auto corner = [&](std::size_t i) {
        return glm::dvec2(margin + static_cast<double>(i % columns) * (width + margin),
                          margin + static_cast<double>(i / columns) * (height + caption));
    };
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const glm::dvec2 below = corner(i) + glm::dvec2(0, height);
        drawing.add(Text{below + glm::dvec2(0, 17), tiles[i].title, text_ink, title_size});
        drawing.add(Text{below + glm::dvec2(0, 31), fitted(tiles[i].subtitle, note_size, width),
                         note_ink, note_size});
    }
    ImageFile sheet = rasterise(drawing, images, 1);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const glm::dvec2 at = corner(i);
        paste(sheet, tiles[i].picture, static_cast<std::size_t>(at.x),
              static_cast<std::size_t>(at.y));
    }
    return sheet;
}

}  // namespace lobe
