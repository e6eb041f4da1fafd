// SPDX-License-Identifier: Apache-2.0
// References: rendered once, kept, found again, and never taken from a file that is not theirs.
#include "study/reference.h"

#include <filesystem>
#include <fstream>

#include "base/files.h"
#include "base/statistics.h"
#include "report/image_io.h"
#include "study/reference_file.h"
#include "support/device.h"
#include "support/probe.h"
#include "support/scenes.h"
#include "support/temp_folder.h"

using namespace lobe;
using namespace lobe::test;

namespace fs = std::filesystem;

namespace {

// A lit wall with a lamp in the picture, in a cache of its own.
class References : public testing::Test {
  protected:
    References() : cache_("LOBE_CACHE_DIR", folder_.path().c_str()) {
        add(scene_, wall(4, 3));
        shine(add(scene_, {0, 1, 3}, .2), 10);
    }

    Arm arm(Integrator integrator = {}) const {
        return Arm("wall", test_device(), kernels_, scene_,
                   {read_brdf_tables(kernels_), false, integrator});
    }
    std::optional<Reference> reference(const Arm& of, std::uint32_t samples,
                                       const std::function<bool()>& stop = {}) {
        return reference_of(test_device(), kernels_, of, samples, images_, stop);
    }
    std::vector<std::string> kept() const {
        std::vector<std::string> files;
        std::error_code none;
        for (const auto& entry : fs::directory_iterator(folder_.file("references"), none))
            files.push_back(entry.path());
        return files;
    }

    TempFolder folder_;
    ScopedVariable cache_;
    KernelText kernels_ = test_kernels();
    Scene scene_ = small_scene(.5, 16);
    ImageIo images_;
};

void expect_same(const Reference& a, const Reference& b) {
    EXPECT_EQ(a.rgb, b.rgb);
    EXPECT_EQ(a.standard_error, b.standard_error);
    EXPECT_EQ(a.luminance_error, b.luminance_error);
    EXPECT_EQ(a.masked, b.masked);
    EXPECT_EQ(a.samples, b.samples);
    EXPECT_EQ(a.seed, b.seed);
}

}  // namespace

TEST_F(References, AreKeptAndFoundAgain) {
    const Arm wall = arm();
    const auto first = reference(wall, 60);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->samples, 64u);  // whole blocks
    EXPECT_FALSE(first->from_cache);
    EXPECT_GE(first->seed, reference_seed_bit);
    ASSERT_EQ(first->masked.size(), 256u);
    const auto lit = std::count(first->masked.begin(), first->masked.end(), true);
    EXPECT_GT(lit, 0);
    EXPECT_LT(lit, 30);
    EXPECT_EQ(kept(), std::vector<std::string>{first->file});
    for (const std::uint32_t samples : {8u, 64u}) {
        const auto again = reference(wall, samples);
        ASSERT_TRUE(again);
        EXPECT_TRUE(again->from_cache);
        expect_same(*first, *again);
    }
    const auto better = reference(wall, 65);
    ASSERT_TRUE(better);
    EXPECT_FALSE(better->from_cache);
    EXPECT_EQ(better->samples, 72u);
    EXPECT_EQ(kept(), std::vector<std::string>{better->file});  // in place of the lesser one
}

TEST_F(References, DependOnTheSceneAndNotOnTheIntegrator) {
    const auto first = reference(arm(), 8);
    Integrator cosine;
    cosine.directions = Integrator::Directions::cosine;
    cosine.strategy = Integrator::Strategy::brdf;
    const auto shared = reference(arm(cosine), 8);
    ASSERT_TRUE(first && shared);
    EXPECT_TRUE(shared->from_cache);
    fs::remove(first->file);
    const auto rendered = reference(arm(cosine), 8);
    ASSERT_TRUE(rendered);
    EXPECT_FALSE(rendered->from_cache);
    expect_same(*first, *rendered);

    scene_.max_depth = 1;
    const auto other = reference(arm(), 8);
    ASSERT_TRUE(other);
    EXPECT_FALSE(other->from_cache);
    EXPECT_EQ(kept().size(), 2u);
}

TEST_F(References, DamagedFilesAreRenderedAnew) {
    const Arm wall = arm();
    const auto first = reference(wall, 8);
    ASSERT_TRUE(first);
    const std::string whole = read_file(first->file);
    std::string flipped = whole;
    flipped[whole.size() - 40] ^= 1;  // within the last row
    for (const std::string& bad :
         {flipped, whole.substr(0, whole.size() / 2), std::string("x"), std::string()}) {
        std::ofstream(first->file, std::ios::binary) << bad;
        const auto again = reference(wall, 8);
        ASSERT_TRUE(again);
        EXPECT_FALSE(again->from_cache) << bad.size() << " bytes";
        expect_same(*first, *again);
        EXPECT_TRUE(reference(wall, 8)->from_cache);
    }
    // Another scene's, under this one's name.
    scene_.max_depth = 1;
    const auto other = reference(arm(), 8);
    ASSERT_TRUE(other);
    fs::rename(other->file, first->file);
    const auto again = reference(wall, 8);
    ASSERT_TRUE(again);
    EXPECT_FALSE(again->from_cache);
    expect_same(*first, *again);
}

// Runs hit slivers of the lamp that a reference with few samples misses.
TEST_F(References, MaskHasTheNeighboursToo) {
    Arm wall = arm();
    const auto few = reference(wall, 8);
    ASSERT_TRUE(few);
    const std::vector<bool> raw =
        checked_reference(images_.read(few->file), wall.content_hash()).masked;
    EXPECT_NE(raw, few->masked);
    EXPECT_EQ(widened(raw, few->width), few->masked);
    EXPECT_EQ(reference(wall, 8)->masked, few->masked);  // and is not widened again
    EXPECT_EQ(read_reference(few->file, 16, 16, images_).masked, few->masked);
    const ArmRun run = wall.run(1, 256);
    for (std::size_t p = 0; p < few->masked.size(); ++p)
        EXPECT_LE(run.picture.sees_light[p], few->masked[p]) << p;
}

TEST_F(References, ArmsReopenToTheSamePicture) {
    Arm wall = arm();
    const double start = wall.start_up().total();
    const std::vector<float> first = wall.run(1, 8).picture.rgb;
    wall.close();
    EXPECT_EQ(wall.width(), 16u);
    wall.reopen();
    EXPECT_EQ(wall.run(1, 8).picture.rgb, first);
    EXPECT_EQ(wall.start_up().total(), start);
}

TEST_F(References, StoppedOnesAreNotKept) {
    int asked = 0;
    EXPECT_FALSE(reference(arm(), 1u << 20, [&] { return ++asked > 3; }));
    EXPECT_TRUE(kept().empty());
}

TEST_F(References, WorkWithoutACache) {
    folder_.write("references", "a file where the folder should be");
    const auto rendered = reference(arm(), 8);
    ASSERT_TRUE(rendered);
    EXPECT_EQ(rendered->file, "");
    EXPECT_FALSE(rendered->from_cache);
}

TEST_F(References, OfTheUsersOwn) {
    ImageFile picture;
    picture.width = picture.height = picture.full_width = picture.full_height = 2;
    picture.channels = {"R", "G", "B", "StdError.R", "StdError.G", "StdError.B"};
    for (int p = 0; p < 4; ++p)
        picture.pixels.insert(picture.pixels.end(), {1, 2, 3, .1f, .1f, .1f});
    images_.write(folder_.file("own.exr"), picture);
    const Reference own = read_reference(folder_.file("own.exr"), 2, 2, images_);
    EXPECT_EQ(own.rgb[4], 2);
    EXPECT_EQ(own.standard_error[4], .1f);
    EXPECT_NEAR(own.luminance_error[3], .1, 1e-7);
    EXPECT_EQ(own.masked, std::vector<bool>(4));
    EXPECT_THROW(read_reference(folder_.file("own.exr"), 2, 3, images_), Error);
    EXPECT_THROW(read_reference(folder_.file("none.exr"), 2, 2, images_), Error);
    picture.pixels[0] = NAN;
    images_.write(folder_.file("own.exr"), picture);
    EXPECT_THROW(read_reference(folder_.file("own.exr"), 2, 2, images_), Error);
}
