// SPDX-License-Identifier: Apache-2.0
// What the verbs that measure models share: the models, their parameters, the device.
#pragma once

#include <optional>

#include "app/brdf_command.h"
#include "cl/device.h"
#include "lab/settings.h"

namespace lobe {

struct LabOptions {
    CommonOptions common;
    std::vector<std::string> models, settings;
};
void add_lab_options(CLI::App& verb, LabOptions& options);

struct Lab {
    KernelText kernels;
    std::vector<BrdfTable> models;  // all there are
    std::vector<Subject> subjects;  // those named, in order
    Device device;

    BrdfProbe probe(const Subject& subject) const {
        return BrdfProbe(device, kernels, subject.model);
    }
    // In double where the device can: for what depends on the model alone, not on rounding.
    BrdfProbe precise_probe(const Subject& subject) const {
        return BrdfProbe(device, kernels, subject.model,
                         device.info().fp64 ? Precision::twice : Precision::single);
    }
};

// The models that the options name, `more` among them, as their settings want them; a user's own
// are tried first. Nothing if a signal asked to stop meanwhile. Throws Error (usage, scene).
std::optional<Lab> open_lab(const LabOptions& options, const std::vector<std::string>& more = {});

// Of words [MODEL.]NAME the name that is for a model, or "".
std::string named_for(const std::vector<std::string>& words, const std::string& model);

}  // namespace lobe
