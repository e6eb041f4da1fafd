// SPDX-License-Identifier: Apache-2.0
// The first run of a user's own model: in a process of its own, for a running kernel can be neither
// stopped nor kept from writing where it must not.
//
// The trial builds the model and calls its functions at the ends of its parameters and for
// directions good and bad, with a fence around all memory that it is given. It finds crashes,
// stores beyond buffers and calls that do not end. It is a net for mistakes, not for malice: what
// runs on a CPU may do all that its user may.
#pragma once

#include <string>

#include "scene/brdf_table.h"

namespace lobe {

class Device;
class KernelText;

struct TrialOptions {
    std::string program = "/proc/self/exe";  // lobe itself
    std::string kernel_folder;               // as of --kernel-dir
    std::string version;                     // lobe's
    double seconds = 20;  // that one step may take; there are some dozens, each short
};

// Tries the model, which was added to `kernels`, unless lobe's cache folder remembers that it has
// passed: its text, the kernels, the device and lobe being the same. Throws Error: scene for what
// does not build, at its place in the user's file; device for a crash, a store beyond a buffer or
// a step past its time. False if a signal asked to stop before there was a verdict.
[[nodiscard]] bool try_model(const Device& device, const KernelText& kernels,
                             const BrdfTable& model, const TrialOptions& options);

// The other side, in the process that try_model starts: carries out the trial and tells each step
// and the verdict on standard output. Returns the exit code.
int serve_trial(const Device& device, const KernelText& kernels, const BrdfTable& model,
                const std::string& version);

// Seconds of a step: the environment's LOBE_TRIAL_SECONDS, else 20.
double trial_seconds();

}  // namespace lobe
