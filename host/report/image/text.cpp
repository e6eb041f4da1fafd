// SPDX-License-Identifier: Apache-2.0
// Text on pictures. OpenImageIO up to 2.4 loses all but the last byte of a character that is not
// ASCII: those that plots need are made of smaller ASCII ones, raised.
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <array>
#include <cmath>

#include "report/image_file.h"

namespace {

// A stretch of text of one size, and how far above the baseline it stands.
struct Run {
    std::string text;
    int size;
    double rise;
    double width = 0;
};

struct Stand {
    const char* character;
    char ascii;
    double rise;  // of the text's size
};
constexpr std::array<Stand, 14> raised = {{{"°", 'o', 0.36},
                                           {"·", '.', 0.28},
                                           {"ⁿ", 'n', 0.36},
                                           {"⁻", '-', 0.36},
                                           {"⁰", '0', 0.36},
                                           {"¹", '1', 0.36},
                                           {"²", '2', 0.36},
                                           {"³", '3', 0.36},
                                           {"⁴", '4', 0.36},
                                           {"⁵", '5', 0.36},
                                           {"⁶", '6', 0.36},
                                           {"⁷", '7', 0.36},
                                           {"⁸", '8', 0.36},
                                           {"⁹", '9', 0.36}}};

// How many bytes the UTF-8 character at the text's place has.
std::size_t character_size(const std::string& text, std::size_t at) {
    std::size_t size = 1;
    while (at + size < text.size() && (static_cast<unsigned char>(text[at + size]) & 0xc0) == 0x80)
        ++size;
    return size;
}

void append(std::vector<Run>& runs, char c, double size, double rise) {
    if (runs.empty() || runs.back().rise != rise)
        runs.push_back({"", static_cast<int>(std::lround(size)), rise});
    runs.back().text += c;
}

std::vector<Run> runs_of(const lobe::Text& text) {
    std::vector<Run> runs;
    for (std::size_t at = 0, size; at < text.text.size(); at += size) {
        size = character_size(text.text, at);
        const std::string character = text.text.substr(at, size);
        const Stand* stand = nullptr;
        for (const Stand& s : raised)
            if (character == s.character) stand = &s;
        if (stand)
            append(runs, stand->ascii, 0.68 * text.size, stand->rise * text.size);
        else
            append(runs, size == 1 ? character[0] : '?', text.size, 0);
    }
    return runs;
}

// Each run's width; a full stop after it keeps the width of spaces at its end.
double measure(std::vector<Run>& runs, const char* font) {
    double width = 0;
    for (Run& run : runs) {
        const int stop = OIIO::ImageBufAlgo::text_size(".", run.size, font).xend;
        run.width = OIIO::ImageBufAlgo::text_size(run.text + ".", run.size, font).xend - stop;
        width += run.width;
    }
    return width;
}

bool draw(OIIO::ImageBuf& buffer, const std::vector<Run>& runs, const char* font, double x,
          double y, const lobe::Ink& ink) {
    const float colour[] = {float(ink.red), float(ink.green), float(ink.blue)};
    for (const Run& run : runs) {
        if (!OIIO::ImageBufAlgo::render_text(buffer, static_cast<int>(std::lround(x)),
                                             static_cast<int>(std::lround(y - run.rise)), run.text,
                                             run.size, font, colour))
            return false;
        x += run.width;
    }
    return true;
}

}  // namespace

extern "C" void lobe_draw_texts(lobe::ImageFile& image, const char* font,
                                const std::vector<lobe::Text>& texts, std::string& error) {
    const OIIO::ImageSpec spec(static_cast<int>(image.width), static_cast<int>(image.height), 3,
                               OIIO::TypeDesc::FLOAT);
    OIIO::ImageBuf buffer(spec, image.pixels.data());
    for (const lobe::Text& text : texts) {
        std::vector<Run> runs = runs_of(text);
        const double width = measure(runs, font);
        const double x = text.at.x - 0.5 * width * static_cast<int>(text.anchor);
        const double rim = text.size / 9;
        bool good = true;
        for (int k = 0; k < 8; ++k)
            good = good && draw(buffer, runs, font, x + rim * std::cos(0.785 * k),
                                text.at.y + rim * std::sin(0.785 * k), {255, 255, 255});
        if (good && draw(buffer, runs, font, x, text.at.y, text.ink)) continue;
        error = buffer.geterror();
        return;
    }
}
