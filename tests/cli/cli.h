// SPDX-License-Identifier: Apache-2.0
// What the tests of the command line share: the program, a small scene, and a folder to work in.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/process.h"
#include "support/temp_folder.h"

namespace lobe::test {

// A plane, two spheres (one a light), two models: 32x24 pixels, 4 samples.
inline const char* const small_scene =
    R"(LookAt 0 -4 2  0 0 0.5  0 0 1
Camera "perspective" "float fov" [40]
Film "rgb" "integer xresolution" [32] "integer yresolution" [24]
Sampler "halton" "integer pixelsamples" [4]
WorldBegin
LightSource "infinite" "rgb L" [.3 .3 .3]
AttributeBegin
    Translate 2 -2 3
    AreaLightSource "diffuse" "rgb L" [20 20 20]
    Shape "sphere" "float radius" [.3]
AttributeEnd
Material "diffuse" "rgb reflectance" [.5 .5 .5]
Shape "trianglemesh" "point3 P" [-5 -5 0 5 -5 0 5 5 0 -5 5 0] "integer indices" [0 1 2 0 2 3]
Material "rational" "rgb kd" [.1 .02 .02] "rgb ks" [.2 .2 .2] "float n" [100]
Translate 0 0 .5
Shape "sphere" "float radius" [.5]
)";

// Runs `lobe` in a folder of its own, which holds scene.pbrt and nothing else to begin with.
class Cli : public testing::Test {
  protected:
    Cli();

    // lobe ARGUMENTS...
    RunResult lobe(const std::vector<std::string>& arguments, RunOptions options = {}) const;
    // lobe render scene.pbrt ARGUMENTS..., which must succeed; its results as JSON.
    nlohmann::json render(std::vector<std::string> arguments, const RunOptions& options = {}) const;
    // Its image_hash.
    std::string hash(const std::vector<std::string>& arguments,
                     const RunOptions& options = {}) const;

    // The scene with the first `old` replaced.
    void write_scene(const std::string& old, const std::string& fresh) const;
    std::string path(const std::string& name) const { return folder_.file(name); }
    // Names in the working folder, hidden ones too, sorted: "out.exr scene.pbrt".
    std::string files() const;

    TempFolder folder_;
};

// The whole of standard error is "lobe: error: " + `error` and, unless `hint` is empty, a line
// "lobe: hint: " that holds `hint`; nothing is on standard output.
void expect_fault(const RunResult& result, int code, const std::string& error,
                  const std::string& hint = "");

// The command line of a run, for messages.
std::string joined(const std::vector<std::string>& words);

}  // namespace lobe::test
