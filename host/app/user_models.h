// SPDX-License-Identifier: Apache-2.0
// Models of the user's own, from the command line to the first run.
#pragma once

#include <string>
#include <vector>

#include "app/command.h"
#include "scene/scene.h"

namespace lobe {

class Device;

// Adds the models of --brdf FILE... to the kernels, under their paths as typed; a file that is
// named twice counts once. Throws Error (scene) as read_user_model does.
void add_user_models(KernelText& kernels, const std::vector<std::string>& files);

// In a list of models, each word that is a file ("velvet.cl", "./velvet") is added to the kernels
// and gives way to its model's name.
void add_user_files(KernelText& kernels, std::vector<std::string>& words);

// Throws Error (scene), with what to type, if the scene itself names kernels and they are not
// trusted: to render them is to run a program that came with the scene.
void check_trust(const Scene& scene, bool trusted);

// Runs those of `models` that are the user's own for the first time, in processes of their own, as
// try_model does. False if a signal asked to stop.
[[nodiscard]] bool try_user_models(const Device& device, const KernelText& kernels,
                                   const std::vector<BrdfTable>& models,
                                   const CommonOptions& options);

}  // namespace lobe
