// SPDX-License-Identifier: Apache-2.0
// Parameters of models as they are typed: "n=100", "kd=0.1,0.2,0.3", "lobe=abs", "phong.n=1e6".
#pragma once

#include <string>
#include <vector>

#include "lab/brdf_probe.h"

namespace lobe {

struct Setting {
    std::string model;  // empty: of every model that has such a parameter
    std::string name, value;
};

// Throws Error (usage) for a text that is not [MODEL.]NAME=VALUE.
Setting parse_setting(const std::string& text);

// A model with its parameters, and the measured numbers that they name.
struct Subject {
    BrdfTable model;
    BrdfRows rows;
    std::vector<float> tables;

    // "n 10, lobe abs": what differs from the defaults, or "defaults".
    std::string text() const;
};

// The defaults of a model, changed by the settings that are meant for it. A table is the file of
// its setting, or a made-up material where there is none. Throws Error (usage) for a value that the
// parameter's row does not permit, with what it does, and as read_measured does.
Subject set_up(const BrdfTable& model, const std::vector<Setting>& settings);

// Throws Error (usage) for a setting that none of the models takes.
void check_settings(const std::vector<BrdfTable>& models, const std::vector<Setting>& settings);

// The value of one parameter as a person writes it: "0.25", "0.1 0.2 0.3", "clamp".
std::string value_text(const BrdfParameter& parameter, const std::array<float, 4>& row);

// "color", "number", ...
const char* kind_name(BrdfParameterKind kind);

}  // namespace lobe
