// SPDX-License-Identifier: Apache-2.0
#include "report/image_io.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "base/files.h"
#include "base/module.h"
#include "report/exr_file.h"
#include "report/png_file.h"

namespace lobe {

struct ImageIo::Module {
    lobe::Module file{"lobe_image.so"};
    ReadImage read = file.function<ReadImage>("lobe_read_image");
    DrawTexts draw_texts = file.function<DrawTexts>("lobe_draw_texts");
};

ImageIo::ImageIo() = default;
ImageIo::~ImageIo() = default;

const ImageIo::Module& ImageIo::module() {
    if (!module_) module_ = std::make_unique<const Module>();
    if (!module_->read || !module_->draw_texts)
        throw Error(ExitCode::output,
                    "the image module lobe_image.so cannot be opened: " + module_->file.error(), "",
                    "it belongs beside the program, and OpenImageIO must be installed");
    return *module_;
}

std::string image_format(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == ".exr") return "exr";
    if (ending == ".png") return "png";
    throw Error(ExitCode::usage, "cannot write a picture of type '" + ending + "'", path,
                "pictures end in .exr (float, with error bars) or .png (sRGB)");
}

namespace {

// Channels may come back in another order: compared by name.
void compare(const ImageFile& wanted, const ImageFile& found, const std::string& path) {
    const std::size_t pixels = static_cast<std::size_t>(wanted.width) * wanted.height;
    const std::size_t n = wanted.channels.size();
    bool same =
        found.width == wanted.width && found.height == wanted.height && found.channels.size() == n;
    for (std::size_t c = 0; same && c < n; ++c) {
        const auto at = std::find(found.channels.begin(), found.channels.end(), wanted.channels[c]);
        if (at == found.channels.end()) {
            same = false;
            break;
        }
        const std::size_t d = static_cast<std::size_t>(at - found.channels.begin());
        for (std::size_t p = 0; same && p < pixels; ++p)
            same = !std::memcmp(&wanted.pixels[p * n + c], &found.pixels[p * n + d], sizeof(float));
    }
    if (!same)
        throw Error(ExitCode::output, "what was written does not read back the same", path,
                    "is the disk full?");
}

}  // namespace

void ImageIo::write(const std::string& path, const ImageFile& image) {
    AtomicFile file(path);
    ImageFile back;
    try {
        if (image_format(path) == "exr") {
            write_exr(file.temporary(), image);
            back = read_exr(file.temporary());
        } else {
            std::ofstream(file.temporary(), std::ios::binary) << to_png(image);
            back = from_png(read_file(file.temporary()));
        }
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        throw Error(ExitCode::output, std::string("cannot write the picture: ") + error.what(),
                    path);
    }
    compare(image, back, path);
    file.commit();
}

std::string ImageIo::png(const ImageFile& image) {
    try {
        return to_png(image);
    } catch (const std::runtime_error& error) {
        throw Error(ExitCode::output, std::string("cannot encode a picture: ") + error.what());
    }
}

ImageFile ImageIo::read(const std::string& path) {
    ImageFile image;
    std::string error;
    module().read(path.c_str(), image, error);
    if (!error.empty()) throw Error(ExitCode::scene, "cannot read the picture: " + error, path);
    return image;
}

void ImageIo::draw_texts(ImageFile& image, const std::string& font,
                         const std::vector<Text>& texts) {
    std::string error;
    module().draw_texts(image, font.c_str(), texts, error);
    if (!error.empty()) throw Error(ExitCode::output, "cannot draw text: " + error, font);
}

}  // namespace lobe
