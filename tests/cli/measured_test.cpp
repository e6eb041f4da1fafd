// SPDX-License-Identifier: Apache-2.0
// Scenes whose materials are files of measured reflectance.
#include <cmath>

#include "cli.h"
#include "scene/measured_files.h"

using namespace lobe;
using namespace lobe::test;

namespace {

class MeasuredScene : public Cli {
  protected:
    // The scene with its glossy ball of a file.
    void use(const std::string& file) const {
        write_scene(
            R"(Material "rational" "rgb kd" [.1 .02 .02] "rgb ks" [.2 .2 .2] "float n" [100])",
            "Material \"measured\" \"string filename\" \"" + file + "\"");
    }
};

}  // namespace

TEST_F(MeasuredScene, BothLayoutsGiveOnePicture) {
    write_merl(path("a.binary"), made_up_material());
    write_measured_text(path("a.txt"), made_up_material());
    use("a.binary");
    const auto binary = render({});
    EXPECT_EQ(binary["features"]["brdfs"], nlohmann::json({"lambert", "measured"}));
    EXPECT_EQ(binary["nonfinite"], 0);
    use("a.txt");
    EXPECT_EQ(render({})["image_hash"], binary["image_hash"]);
    EXPECT_EQ(render({"--features", "all"})["image_hash"], binary["image_hash"]);
}

TEST_F(MeasuredScene, FaultsOfFilesAreSaid) {
    use("a.bsdf");
    folder_.write("a.bsdf", std::string("tensor_file\0\1\0", 14));
    expect_fault(lobe({"render", "scene.pbrt"}), 3,
                 "a.bsdf: tensor files (.bsdf) of adaptively measured reflectance are understood "
                 "but not supported yet",
                 "MERL");
    use("a.binary");
    folder_.write("a.binary", std::string("\x5a\0\0\0\x5a\0\0\0\xb4\0\0\0", 12));
    expect_fault(lobe({"render", "scene.pbrt"}), 3,
                 "a.binary: a table of 90 x 90 x 180 cells has 34992012 bytes, the file 12",
                 "is it all there?");
    use("a.txt");
    folder_.write("a.txt", "brdf 1 1 1\n1 2 x\n");
    expect_fault(lobe({"render", "scene.pbrt"}), 3, "a.txt:2:5: 'x' is not a number");
}
