// SPDX-License-Identifier: Apache-2.0
// Scene options in one text, as `lobe compare --a "..."` takes them, and the arm that they make.
#pragma once

#include <memory>
#include <optional>

#include "app/command.h"
#include "app/scene_options.h"
#include "base/error.h"
#include "study/arm.h"

namespace lobe {

// The words of a text as a shell would see them: parted by blanks, but for '...' and "...". Throws
// Error (usage) for a quote without its end.
std::vector<std::string> split_words(const std::string& text);

// `base` with the options of `text` put over it; models and replacements are added to those of
// `base`, whose replacements give way. `name` is the option that holds the text, for errors. Throws
// Error (usage) for what is no scene option, and for --spp: an experiment chooses that.
SceneOptions arm_options(const SceneOptions& base, const std::string& name,
                         const std::string& text);

// The same error, said to be in an option that holds others.
Error in_option(const std::string& name, const Error& error);

// What an arm is made of.
struct ArmParts {
    Scene scene;
    PackOptions pack;
    double parse_seconds = 0;
};

// Reads what the options name, and tries models that are the user's own, which `kernels` gets.
// Nothing if a signal asked to stop. Throws Error as read_scene_for and check_trust.
std::optional<ArmParts> read_arm(const Device& device, KernelText& kernels,
                                 const SceneOptions& options, const CommonOptions& common);

// Reads and compiles what the options name, after a trial of models that are the user's own.
// `kernels` gets those models and must outlive the arm. Nothing if a signal asked to stop. Throws
// Error as read_scene_for, check_trust and Arm's constructor.
std::unique_ptr<Arm> open_arm(const std::string& name, const Device& device, KernelText& kernels,
                              const SceneOptions& options, const CommonOptions& common);

}  // namespace lobe
