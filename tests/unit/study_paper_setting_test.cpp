// SPDX-License-Identifier: Apache-2.0
// The paper's settings: kd, ks and n of each are what is said, and the scene wears them.
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene_test_support.h"
#include "study/paper/page.h"
#include "study/paper/setting.h"

using namespace lobe;
using namespace lobe::test;

namespace {

// Stands for the device: albedos and widths that are easy to reckon with.
const LobeMeasure fake = {
    [](const std::string& model, double n) {
        if (model == "rational") return 8 / n;
        return model == "phong" ? 2 / n : 4 / n;
    },
    [](const std::string& model, double n) { return model == "phong" ? n / 2 + 1 : n / 2; }};

std::vector<BrdfTable> tables() {
    std::vector<BrdfTable> all = models();
    for (const std::string name : {"rational", "phong"})
        all.push_back(parse_brdf_table(
            "brdf/" + name + ".h",
            "#define " + name +
                "_parameters(P) \\\nP(color, kd, 0.25, 0, inf, \"\") "
                "P(color, ks, 0.25, 0, inf, \"\") P(number, n, 100, 0, inf, \"\") "
                "P(choice, normalize, 0, 0, 1, \"false|true: albedos\") " +
                (name == "rational" ? "P(choice, lobe, 0, 0, 2, \"clamp|abs|listing: reading\")"
                                    : "") +
                "\n"));
    return all;
}

Scene scene_of(const std::string& materials) {
    std::string text;
    for (std::size_t at = 0, next; at < materials.size(); at = next + 1) {
        next = materials.find('\n', at);
        text += materials.substr(at, next - at) + "\nShape \"sphere\"\n";
    }
    const TempFolder folder;
    return read_scene(folder.write("s.pbrt", world3(text)), tables());
}

const char* const three =
    "Material \"matte\" \"rgb Kd\" [.5 .5 .5]\n"
    "Material \"plastic\" \"rgb Kd\" [.1 .2 .3] \"rgb Ks\" [.5 .25 .125]\n"
    "Material \"rational\" \"rgb kd\" [.4 .2 .1] \"rgb ks\" [.3 .6 .9] \"float n\" [1000] "
    "\"bool normalize\" \"true\"\n";

std::vector<Wearer> wearers_of(const Scene& scene, std::optional<double> n = {}) {
    return find_wearers(scene, tables(), {"plastic", "rational"}, n, fake);
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 1e-6 * std::abs(b[c])) << c;
}

}  // namespace

TEST(PaperSetting, WearersHaveBrdfValues) {
    const std::vector<Wearer> wearers = wearers_of(scene_of(three));
    ASSERT_EQ(wearers.size(), 2u);
    EXPECT_EQ(wearers[0].type, "plastic");
    expect_near(wearers[0].base.kd, glm::dvec3(.1, .2, .3) / glm::pi<double>());
    expect_near(wearers[0].base.ks, {.5, .25, .125});
    EXPECT_EQ(wearers[0].base.n, 100);
    // Albedos: kd over pi, ks over the lobe's own.
    expect_near(wearers[1].base.kd, glm::dvec3(.4, .2, .1) / glm::pi<double>());
    expect_near(wearers[1].base.ks, glm::dvec3(.3, .6, .9) / (8 / 1000.0));
    EXPECT_EQ(wearers[1].base.n, 1000);
}

TEST(PaperSetting, GivenNWinsAndKsKeepsItsValue) {
    const std::vector<Wearer> wearers = wearers_of(scene_of(three), 50);
    EXPECT_EQ(wearers[0].base.n, 50);
    EXPECT_EQ(wearers[1].base.n, 50);
    expect_near(wearers[1].base.ks, glm::dvec3(.3, .6, .9) / (8 / 1000.0));
}

TEST(PaperSetting, SevenAndTheListing) {
    const std::vector<ModelSetting> settings = paper_settings(wearers_of(scene_of(three)), fake);
    ASSERT_EQ(settings.size(), listing_setting + 1);
    const glm::dvec3 kd = glm::dvec3(.1, .2, .3) / glm::pi<double>(), ks(.5, .25, .125);
    struct Row {
        std::size_t place;
        const char* model;
        double ks, n;
    };
    for (const Row& row : {Row{0, "rational", 1, 100},
                           {setting_of(1, Footing::parameters), "phong", 1, 100},
                           {setting_of(2, Footing::parameters), "modified_phong", 1, 100},
                           {setting_of(1, Footing::albedo), "phong", 4, 100},
                           {setting_of(2, Footing::albedo), "modified_phong", 2, 100},
                           {setting_of(1, Footing::half_width), "phong", 1, 51},
                           {setting_of(2, Footing::half_width), "modified_phong", 1, 50},
                           {listing_setting, "rational", 1, 100}}) {
        const ModelSetting& setting = settings[row.place];
        SCOPED_TRACE(setting.name());
        EXPECT_EQ(setting.model, row.model);
        EXPECT_EQ(setting.listing, row.place == listing_setting);
        expect_near(setting.parameters[0].kd, kd);
        expect_near(setting.parameters[0].ks, row.ks * ks);
        EXPECT_EQ(setting.parameters[0].n, row.n);
    }
    for (const Footing footing : footings) EXPECT_EQ(setting_of(0, footing), 0u);
}

TEST(PaperSetting, SceneIsDressed) {
    const Scene scene = scene_of(three);
    const std::vector<Wearer> wearers = wearers_of(scene);
    const std::vector<ModelSetting> settings = paper_settings(wearers, fake);
    for (const ModelSetting& setting : settings) {
        const Scene worn = dressed(scene, wearers, setting, tables());
        SCOPED_TRACE(setting.name());
        for (std::size_t i = 0; i < scene.materials.size(); ++i) {
            const Material& material = worn.materials[i];
            if (i != wearers[0].material && i != wearers[1].material) {
                EXPECT_EQ(material.brdf, scene.materials[i].brdf);
                EXPECT_EQ(material.rows, scene.materials[i].rows);
                continue;
            }
            const std::size_t w = i == wearers[1].material;
            EXPECT_EQ(material.brdf, setting.model);
            ASSERT_EQ(material.rows.size(), setting.model == "rational" ? 5u : 4u);
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_EQ(material.rows[0][c], float(setting.parameters[w].kd[int(c)]));
                EXPECT_EQ(material.rows[1][c], float(setting.parameters[w].ks[int(c)]));
            }
            EXPECT_EQ(material.rows[2][0], float(setting.parameters[w].n));
            EXPECT_EQ(material.rows[3][0], 0);  // never normalised
            if (setting.model == "rational") {
                EXPECT_EQ(material.rows[4][0], setting.listing ? 2 : 0);
            }
        }
    }
}

TEST(PaperSetting, RefusesWhatCannotBeCompared) {
    const auto fault = [](const Scene& scene, std::optional<double> n) -> std::string {
        try {
            wearers_of(scene, n);
        } catch (const Error& error) {
            return error.what() + std::string(" | ") + error.hint();
        }
        return "";
    };
    const Scene matte = scene_of("Material \"matte\"\n");
    EXPECT_NE(fault(matte, {}).find("no material of the scene is plastic or rational"),
              std::string::npos);
    EXPECT_NE(fault(matte, {}).find("matte"), std::string::npos);
    for (const double n : {0.0, double(INFINITY)})
        EXPECT_NE(fault(scene_of(three), n).find("has no lobe"), std::string::npos) << n;
}

TEST(PaperPage, CropIsWhereThePicturesDiffer) {
    const std::uint32_t width = 100, height = 60;
    std::vector<float> a(3 * width * height, 1), b = a;
    b[3 * (50 * width + 70) + 1] = 9;
    const Crop crop = busiest_crop(a, b, width, height, 32);
    EXPECT_EQ(crop.width, 32u);
    EXPECT_EQ(crop.height, 32u);
    EXPECT_TRUE(crop.x <= 70 && 70 < crop.x + 32 && crop.x + 32 <= width) << crop.x;
    EXPECT_TRUE(crop.y + 32 <= height) << crop.y;
    const Crop all = busiest_crop(a, b, width, height, 256);
    EXPECT_EQ(all.width, width);
    EXPECT_EQ(all.height, height);
}
