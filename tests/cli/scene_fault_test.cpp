// SPDX-License-Identifier: Apache-2.0
// Scenes that cannot be rendered: exit code 3, the place, the nearest name, and nothing written.
#include "cli.h"

using namespace lobe::test;

namespace {

class SceneFault : public Cli {
  protected:
    // Renders the scene with `old` replaced; it must be refused before any device is asked.
    void refuse(const std::string& old, const std::string& fresh, const std::string& error,
                const std::string& hint = "") {
        SCOPED_TRACE(fresh);
        write_scene(old, fresh);
        RunOptions options;
        options.environment = {{"OCL_ICD_VENDORS", "/nonexistent"}};
        for (const char* verb : {"render", "features"})
            expect_fault(lobe({verb, "scene.pbrt"}, options), 3, error, hint);
        EXPECT_EQ(files(), "scene.pbrt");
    }
};

}  // namespace

TEST_F(SceneFault, MissingFile) {
    expect_fault(lobe({"render", "missing.pbrt", "-o", "out.exr"}), 3,
                 "missing.pbrt: cannot read the file: No such file or directory", "spelt");
    expect_fault(lobe({"render", ".", "-o", "out.exr"}), 3,
                 ".: cannot read the file: Is a directory", "name a file in it");
    EXPECT_EQ(files(), "scene.pbrt");
}

TEST_F(SceneFault, Syntax) {
    refuse("Translate 2 -2 3", "Translate 2 -2",
           "scene.pbrt:8:5: Translate wants 3 numbers, has 2");
    refuse("Camera", "Camra", "scene.pbrt:2:1: unknown directive 'Camra'", "'Camera'");
    refuse("[.5]\n", "[.5\n", "scene.pbrt:16:31: a list of values that does not end",
           "close it with ]");
    refuse("\"halton\"", "\"halton\n", "scene.pbrt:4:9: a string that does not end on its line",
           "close it");
}

TEST_F(SceneFault, UnknownNamesComeWithTheNearest) {
    refuse("\"rational\"", "\"ratoinal\"", "scene.pbrt:14:10: unknown material \"ratoinal\"",
           "did you mean 'rational'?");
    refuse("\"float n\"", "\"float nn\"",
           "scene.pbrt:14:63: unknown parameter \"nn\" of material \"rational\"", "did you mean");
    refuse("\"sphere\" \"float radius\" [.5]", "\"spere\"",
           "scene.pbrt:16:7: unknown Shape \"spere\"", "did you mean 'sphere'?");
}

TEST_F(SceneFault, UnsupportedIsRefusedByName) {
    refuse("\"rational\"", "\"dielectric\"",
           "scene.pbrt:14:10: material \"dielectric\" is understood but not supported yet",
           "choose");
}

TEST_F(SceneFault, NumbersOutOfRange) {
    refuse("[-5 -5 0", "[nan -5 0", "scene.pbrt:13:34: the number nan is not a number",
           "mend or leave out the shape");
    refuse("[-5 -5 0", "[inf -5 0",
           "scene.pbrt:13:34: parameter \"P\" of type point3 has an infinite value");
    refuse("[100]", "[-2]",
           "scene.pbrt:14:63: parameter \"n\" of material \"rational\" wants 0 or more, has -2",
           "0 rough, infinity a mirror");
    refuse("0 2 3]", "0 2 4]", "scene.pbrt:13:92: vertex index 4 is not one of the 4 vertices");
}

// Control bytes of a scene must not reach the terminal.
TEST_F(SceneFault, MessagesAreOneLineOfPrintableText) {
    refuse("Camera", "Cam\x1b[2J\xff", "scene.pbrt:2:1: unknown directive 'Cam\\x1b'",
           "choose one of");
}

TEST_F(SceneFault, LenientWarnsInstead) {
    write_scene("Camera ", "Nonsense \"x\" 3\nCamera ");
    const RunResult result = lobe({"features", "scene.pbrt", "--lenient"});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.err,
              "lobe: warning: scene.pbrt:2:1: unknown directive 'Nonsense' is left out\n");
}
