// SPDX-License-Identifier: Apache-2.0
// Bring your own BRDF: a file that a person wrote renders like lobe's own models, and what is wrong
// with it is told at its place or found before it can do harm.
#include <signal.h>

#include <filesystem>

#include "base/files.h"
#include "cli.h"
#include "report/image_io.h"

using namespace lobe;
using namespace lobe::test;

namespace {

class UserModel : public Cli {
  protected:
    // velvet.cl as `lobe brdf new` writes it.
    UserModel() {
        const RunResult result = lobe({"brdf", "new", "velvet", "--quiet"});
        EXPECT_EQ(result.code, 0) << result.err;
        EXPECT_EQ(result.out + result.err, "");
        text_ = read_file(path("velvet.cl"));
    }

    // The template with the first `old` replaced, as `file`.
    void mutate(const std::string& old, const std::string& fresh,
                const std::string& file = "velvet.cl") {
        std::string text = text_;
        const std::size_t at = text.find(old);
        ASSERT_NE(at, std::string::npos) << old;
        folder_.write(file, text.replace(at, old.size(), fresh));
    }

    // The line that begins with `text`, counted from one.
    std::string line_of(const std::string& text) const {
        const std::size_t at = text_.find("\n" + text);
        EXPECT_NE(at, std::string::npos) << text;
        return std::to_string(
            2 + std::count(text_.begin(), text_.begin() + static_cast<int>(at), '\n'));
    }

    RunResult render_with(const std::string& file, RunOptions options = {}) const {
        return lobe({"render", "scene.pbrt", "--quiet", "--brdf", file, "--replace",
                     "rational=velvet", "-o", "out.exr"},
                    options);
    }

    // A mistake in the file is refused before anything is written.
    void refuse(int code, const std::string& error, const std::string& hint,
                RunOptions options = {}) const {
        expect_fault(render_with("velvet.cl", options), code, error, hint);
        EXPECT_FALSE(std::filesystem::exists(path("out.exr")));
    }

    std::string text_;
};

const char* const sample_begin = "    if (u.z < m->choice.x) {\n";

RunOptions short_trial(const char* seconds) {
    RunOptions options;
    options.environment = {{"LOBE_TRIAL_SECONDS", seconds}};
    return options;
}

}  // namespace

TEST_F(UserModel, TheTemplateSaysWhatItIs) {
    EXPECT_EQ(text_.find("NAME"), std::string::npos);
    EXPECT_EQ(text_.find("SPDX"), std::string::npos) << "the file is the user's";
    EXPECT_EQ(text_.compare(0, 10, "// velvet:"), 0);
    const RunResult result = lobe({"brdf", "new", "silk_2", "-o", "mine.cl"});
    EXPECT_EQ(result.code, 0);
    EXPECT_NE(result.out.find("lobe brdf check mine.cl"), std::string::npos) << result.out;
    EXPECT_NE(read_file(path("mine.cl")).find("silk_2_eval("), std::string::npos);
    const auto json = nlohmann::json::parse(lobe({"brdf", "new", "felt", "--json", "-"}).out);
    EXPECT_EQ(json["file"], "felt.cl");
}

TEST_F(UserModel, TheTemplatePassesItsChecks) {
    const RunResult result = lobe({"brdf", "check", "velvet.cl", "--json", "-"});
    EXPECT_EQ(result.code, 0) << result.out << result.err;
}

TEST_F(UserModel, NewRefuses) {
    expect_fault(lobe({"brdf", "new", "velvet"}), 5, "velvet.cl: there is such a file already",
                 "-o");
    EXPECT_EQ(read_file(path("velvet.cl")), text_);
    for (const char* name : {"Velvet", "2a", "a-b", "a b", ""})
        expect_fault(lobe({"brdf", "new", name}), 2,
                     "a model cannot be called '" + std::string(name) + "'", "small letter");
    expect_fault(lobe({"brdf", "new", "modifiedphong"}), 2,
                 "the name 'modifiedphong' is taken by lobe's own brdf/modified_phong.h",
                 "another");
    expect_fault(lobe({"brdf", "new", "matte"}), 2,
                 "the name 'matte' is taken by a material of pbrt", "another");
    EXPECT_EQ(files(), "scene.pbrt velvet.cl");
}

// By --brdf and its name, by --replace, and by the file's name in the scene: one picture.
TEST_F(UserModel, Renders) {
    const std::string type =
        "\"rational\" \"rgb kd\" [.1 .02 .02] \"rgb ks\" [.2 .2 .2] \"float n\" "
        "[100]";
    const std::string parameters =
        "\"rgb kd\" [.1 .02 .02] \"rgb ks\" [.2 .2 .2] \"float n\" [100]";
    const std::string replaced = hash({"--brdf", "velvet.cl", "--replace", "rational=velvet"});
    const auto by_name = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"--brdf", "velvet.cl"};
        words.insert(words.end(), more.begin(), more.end());
        return hash(words);
    };
    write_scene(type, "\"velvet\" " + parameters);
    EXPECT_EQ(by_name({}), replaced);
    EXPECT_EQ(by_name({"--features", "all"}), replaced);
    write_scene(type, "\"cloth\" \"string brdf\" \"velvet.cl\" " + parameters);
    EXPECT_EQ(hash({"--trust-scene-kernels"}), replaced);
    EXPECT_EQ(by_name({}), replaced);
    const auto json = nlohmann::json::parse(
        lobe({"features", "scene.pbrt", "--json", "-"}).out);  // to look at it needs no trust
    EXPECT_EQ(json["brdfs"], nlohmann::json({"lambert", "velvet"}));
}

TEST_F(UserModel, AKernelOfTheSceneNeedsTrust) {
    write_scene("\"rational\"", "\"cloth\" \"string brdf\" \"velvet.cl\"");
    expect_fault(lobe({"render", "scene.pbrt", "-o", "out.exr"}), 3,
                 "scene.pbrt:14:32: the scene brings a kernel of its own, velvet.cl",
                 "--brdf velvet.cl or --trust-scene-kernels");
    EXPECT_EQ(files(), "scene.pbrt velvet.cl");
}

// The second time nothing is tried: the model that passed is remembered by all it depends on.
TEST_F(UserModel, IsTriedOnce) {
    RunOptions options;
    options.environment = {{"LOBE_CACHE_DIR", path("cache")}};
    const auto note = [&] {
        return lobe({"render", "scene.pbrt", "--brdf", "velvet.cl", "--replace", "rational=velvet",
                     "-o", "out.exr"},
                    options)
                   .err.find("trying velvet.cl") != std::string::npos;
    };
    EXPECT_TRUE(note());
    EXPECT_FALSE(note());
    mutate("0.2, 0, inf", "0.3, 0, inf");
    EXPECT_TRUE(note());
    EXPECT_FALSE(note());
    std::filesystem::remove_all(path("cache"));
    EXPECT_TRUE(note());
}

TEST_F(UserModel, FaultsOfTheTable) {
    const std::string line = line_of("    P(number, n");
    mutate("P(number, n, 4", "P(numbr, n, 4");
    refuse(3, "velvet.cl:" + line + ":5: a row of velvet_parameters is malformed", "P(color");
    mutate("P(number, n, 4", "P(number, n, 0");
    refuse(3, "velvet.cl:" + line + ":5: the default lies outside its range (velvet's n)", "");
    mutate("velvet_parameters(P)", "velvet_table(P)");
    refuse(3, "velvet.cl:1:1: no table NAME_parameters(P) with its rows", "README");
}

TEST_F(UserModel, FaultsOfTheCode) {
    mutate("m->ks * (", "m->kx * (");
    const std::string line = line_of("    return (m->kd + m->ks");
    const RunResult typo = render_with("velvet.cl");
    EXPECT_EQ(typo.code, 3);
    EXPECT_EQ(typo.err.find("lobe: error: velvet.cl:" + line + ":24: the kernel does not build: "),
              0u)
        << typo.err;
    mutate("real velvet_pdf(const", "real velvet_pfd(const");
    refuse(3, "velvet.cl: the model has no velvet_pdf",
           "write real velvet_pdf(const velvet_prepared* m, real3 wo, real3 wi)");
    mutate("real velvet_pdf(const", "// real velvet_pdf(real x) { }\nreal velvet_pfd(const");
    refuse(3, "velvet.cl: the model has no velvet_pdf", "write");
    mutate("LOBE_BRDF_VALUES(velvet)", "");
    refuse(3, "velvet.cl: the model has no LOBE_BRDF_VALUES(velvet)", "write it after the table");
    mutate("    real n;\n", "    real n, room[200];\n");
    refuse(3, "velvet.cl: velvet_prepared has 848 bytes, more than the 512 there are", "eval");
    mutate("#include \"brdf/lobe.h\"", "#include \"brdf/lobes.h\"");
    const std::string include = line_of("#include \"brdf/lobe.h\"");
    refuse(
        3,
        "velvet.cl:" + include + ":1: there is no kernel file \"brdf/lobes.h\", nor one beside it",
        "\"brdf/lobe.h\"");
}

// A file beside the model's own, and a fault in it.
TEST_F(UserModel, IncludesWhatLiesBesideIt) {
    mutate("#include \"brdf/lobe.h\"", "#include \"brdf/lobe.h\"\n#include \"rim.h\"",
           "m/velvet.cl");
    folder_.write("m/rim.h", "// nothing yet\n");
    EXPECT_EQ(render_with("m/velvet.cl").code, 0);
    folder_.write("m/rim.h", "real rim(real x) {\n    return y;\n}\n");
    const RunResult result = render_with("m/velvet.cl");
    EXPECT_EQ(result.code, 3);
    EXPECT_EQ(result.err.find("lobe: error: m/rim.h:2:12: the kernel does not build: "), 0u)
        << result.err;
}

TEST_F(UserModel, ATakenNameIsRefused) {
    std::string text = text_;
    for (std::size_t at = 0; (at = text.find("velvet", at)) != std::string::npos;)
        text.replace(at, 6, "phong");
    folder_.write("velvet.cl", text);
    const std::string line = line_of("#define velvet_parameters");
    refuse(3, "velvet.cl:" + line + ":9: the name 'phong' is taken by lobe's own brdf/phong.h",
           "another name");
    folder_.write("velvet.cl", text_);
    folder_.write("other.cl", text_);
    expect_fault(lobe({"features", "scene.pbrt", "--brdf", "velvet.cl", "--brdf", "other.cl"}), 3,
                 "other.cl:" + line + ":9: the name 'velvet' is taken by the model of velvet.cl",
                 "another name");
    EXPECT_EQ(lobe({"features", "scene.pbrt", "--brdf", "velvet.cl", "--brdf", "./velvet.cl"}).code,
              0);
}

TEST_F(UserModel, ACrashIsFoundInTheTrial) {
    mutate(sample_begin,
           "    if (wo.x > 0.9f) *(global float*)(ulong)16 = 1;\n" + std::string(sample_begin));
    refuse(4, "velvet.cl: velvet_sample crashed (Segmentation fault) when it was tried",
           "pointers");
    mutate("    real rim = ",
           "    real a[4];\n    for (int i = 0; i < 100000000; ++i)\n"
           "        ((volatile real*)a)[i] = wi.z;\n    real rim = a[0] + ");
    refuse(4, "velvet.cl: velvet_eval crashed (Segmentation fault) when it was tried", "indices");
}

TEST_F(UserModel, AHangIsFoundInTheTrial) {
    mutate(sample_begin, "    volatile int spin = 1;\n    while (isnan(wo.x) && spin) {}\n" +
                             std::string(sample_begin));
    refuse(4, "velvet.cl: velvet_sample did not end within 10 s when it was tried", "loops",
           short_trial("10"));
}

// What a kernel prints does not come between.
TEST_F(UserModel, MayPrint) {
    mutate(sample_begin, "    printf(\"passed x\\n\");\n" + std::string(sample_begin));
    const RunResult result = render_with("velvet.cl");
    EXPECT_EQ(result.code, 0) << result.err.substr(0, 1000);
}

TEST_F(UserModel, ASignalEndsTheTrial) {
    mutate(sample_begin, "    volatile int spin = 1;\n    while (isnan(wo.x) && spin) {}\n" +
                             std::string(sample_begin));
    RunOptions options = short_trial("50");
    options.folder = folder_.path();
    Process process({LOBE_PROGRAM, "render", "scene.pbrt", "--brdf", "velvet.cl", "--replace",
                     "rational=velvet", "-o", "out.exr"},
                    options);
    ASSERT_TRUE(process.wait_for_stderr("trying velvet.cl"));
    process.kill(SIGTERM);
    const RunResult result = process.wait();
    EXPECT_EQ(result.code, 143);
    EXPECT_LT(result.seconds, 30);
    EXPECT_NE(result.err.find("nothing is written"), std::string::npos) << result.err;
    EXPECT_EQ(files(), "scene.pbrt velvet.cl");
}

// A model that hangs once in many thousand samples passes its trial; the watchdog saves what there
// is, and that is what a whole render of as many samples gives.
TEST_F(UserModel, TheWatchdogSavesThePicture) {
    mutate(sample_begin,
           "    volatile int spin = 1;\n    while (u.x > 0.7f && u.x < 0.70001f && spin) {}\n" +
               std::string(sample_begin));
    const std::vector<std::string> words{"--brdf", "velvet.cl", "--replace", "rational=velvet"};
    std::vector<std::string> more{"render",   "scene.pbrt", "-o",     "out.exr",    "--json",
                                  "out.json", "--spp",      "100000", "--watchdog", "0.5"};
    more.insert(more.end(), words.begin(), words.end());
    const RunResult result = lobe(more);
    EXPECT_EQ(result.code, 4) << result.err;
    EXPECT_NE(result.err.find("lobe: error: scene.pbrt: a launch did not end within "),
              std::string::npos)
        << result.err;
    EXPECT_NE(result.err.find("velvet.cl"), std::string::npos);
    EXPECT_NE(result.out.find("(stopped early)"), std::string::npos) << result.out;
    const auto json = nlohmann::json::parse(read_file(path("out.json")));
    EXPECT_EQ(json["partial"], true);
    EXPECT_TRUE(json["nonfinite"].is_null()) << "the device no longer answers";
    const std::uint64_t spp = json["spp"];
    ASSERT_GT(spp, 0u);
    EXPECT_EQ(spp % 8, 0u);
    const auto attributes = ImageIo().read(path("out.exr")).attributes;
    EXPECT_EQ(std::get<std::string>(attributes.at("lobe:partial")), "1");
    EXPECT_EQ(std::get<std::string>(attributes.at("lobe:imageHash")), json["image_hash"]);
    std::vector<std::string> whole = words;
    whole.insert(whole.end(), {"--spp", std::to_string(spp)});
    EXPECT_EQ(hash(whole), json["image_hash"]);
}

TEST_F(UserModel, TheWatchdogLeavesTheOldPictureIfThereIsNoOther) {
    folder_.write("out.exr", "the old picture");
    mutate("    m.n = values.n;\n",
           "    m.n = values.n;\n    volatile int spin = 1;\n"
           "    while (values.n == 123 && spin) {}\n");
    const RunResult result =
        lobe({"render", "scene.pbrt", "--quiet", "--brdf", "velvet.cl", "--replace",
              "rational=velvet", "--n", "123", "-o", "out.exr", "--watchdog", "0.5"});
    EXPECT_EQ(result.code, 4) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("nothing is written"), std::string::npos) << result.err;
    EXPECT_EQ(read_file(path("out.exr")), "the old picture");
}
