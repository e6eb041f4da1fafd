// SPDX-License-Identifier: Apache-2.0
// What lobe writes, another library reads the same: values, names, windows, attributes.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "base/error.h"
#include "base/files.h"
#include "report/exr_file.h"
#include "report/image_io.h"
#include "report/png_file.h"
#include "support/temp_folder.h"

using namespace lobe;
using namespace lobe::test;

namespace {

ImageFile float_image() {
    ImageFile image;
    image.width = 5;
    image.height = 3;
    image.x = 2;
    image.y = 4;
    image.full_width = 20;
    image.full_height = 10;
    image.channels = {"R", "G", "B", "StdError.R", "SampleCount"};
    for (unsigned i = 0; i < 5 * 3 * 5; ++i)
        image.pixels.push_back(static_cast<float>(std::exp(0.7 * i - 20) / 3));
    image.attributes["lobe:seed"] = std::string("17");
    image.attributes["lobe:block"] = 8;
    image.attributes["renderTimeSeconds"] = 0.25;
    return image;
}

ImageFile byte_image(const std::vector<std::string>& channels) {
    ImageFile image;
    image.width = image.full_width = 7;
    image.height = image.full_height = 3;
    image.channels = channels;
    image.bytes = true;
    for (std::size_t i = 0; i < 21 * channels.size(); ++i)
        image.pixels.push_back(static_cast<float>(i * 37 % 256));
    return image;
}

// Of a pixel, by the channel's name.
float value(const ImageFile& image, std::size_t pixel, const std::string& channel) {
    for (std::size_t c = 0; c < image.channels.size(); ++c)
        if (image.channels[c] == channel) return image.pixels[pixel * image.channels.size() + c];
    ADD_FAILURE() << channel;
    return NAN;
}

void expect_same(const ImageFile& a, const ImageFile& b) {
    ASSERT_EQ(a.width, b.width);
    ASSERT_EQ(a.height, b.height);
    EXPECT_EQ(a.x, b.x);
    EXPECT_EQ(a.y, b.y);
    EXPECT_EQ(a.full_width, b.full_width);
    EXPECT_EQ(a.full_height, b.full_height);
    ASSERT_EQ(a.channels.size(), b.channels.size());
    for (const std::string& channel : a.channels)
        for (std::size_t i = 0; i < std::size_t{a.width} * a.height; ++i)
            EXPECT_EQ(value(a, i, channel), value(b, i, channel)) << channel << " " << i;
}

}  // namespace

TEST(PictureFile, ExrIsReadTheSameByAnotherLibrary) {
    const TempFolder folder;
    const ImageFile image = float_image();
    ImageIo images;
    images.write(folder.file("a.exr"), image);
    const ImageFile back = images.read(folder.file("a.exr"));
    expect_same(image, back);
    EXPECT_EQ(std::get<std::string>(back.attributes.at("lobe:seed")), "17");
    EXPECT_EQ(std::get<std::string>(back.attributes.at("lobe:block")), "8");
    EXPECT_EQ(std::get<std::string>(back.attributes.at("renderTimeSeconds")), "0.25");
    expect_same(image, read_exr(folder.file("a.exr")));
}

TEST(PictureFile, TheSamePictureHasTheSameBytes) {
    const TempFolder folder;
    write_exr(folder.file("a.exr"), float_image());
    write_exr(folder.file("b.exr"), float_image());
    EXPECT_EQ(read_file(folder.file("a.exr")), read_file(folder.file("b.exr")));
}

TEST(PictureFile, PngIsReadTheSameByAnotherLibrary) {
    const TempFolder folder;
    ImageIo images;
    for (const auto& channels : std::vector<std::vector<std::string>>{
             {"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}}) {
        const ImageFile image = byte_image(channels);
        images.write(folder.file("a.png"), image);
        const ImageFile back = images.read(folder.file("a.png"));
        EXPECT_TRUE(back.bytes);
        if (channels.size() % 2) {
            EXPECT_EQ(back.pixels, image.pixels);  // the other library multiplies by alpha
        }
        expect_same(image, from_png(to_png(image)));
    }
}

TEST(PictureFile, WhatAFormatCannotHoldIsRefused) {
    const TempFolder folder;
    EXPECT_THROW(to_png(float_image()), std::runtime_error);
    EXPECT_THROW(to_png(byte_image({"a", "b", "c", "d", "e"})), std::runtime_error);
    EXPECT_THROW(from_png("no picture"), std::runtime_error);
    std::ofstream(folder.file("a.exr")) << "no picture";
    EXPECT_THROW(read_exr(folder.file("a.exr")), std::exception);
    EXPECT_THROW(ImageIo().write(folder.file("a.png"), float_image()), Error);
    EXPECT_THROW(write_exr(folder.file("none/a.exr"), float_image()), std::exception);
}
