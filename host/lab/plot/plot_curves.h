// SPDX-License-Identifier: Apache-2.0
// Lobes against the angle to the mirror direction, a panel a model.
#pragma once

#include <string>
#include <vector>

#include "lab/measure/matching.h"
#include "report/drawing.h"

namespace lobe {

struct LobeCurve {
    std::string label;               // "10"
    std::vector<glm::dvec2> points;  // degrees from the mirror direction, lobe over its peak
};

struct LobePanel {
    std::string title, subtitle;
    std::vector<LobeCurve> curves;
};

// The model's lobe at normal incidence for these values of its parameter.
LobePanel lobe_panel(const Sharpened& model, const std::vector<double>& values);
// For a model of which no parameter shapes a lobe: as it is.
LobePanel lobe_panel(BrdfProbe& probe, const Subject& subject);

// Side by side on the same axes; `log`: the lobe on a logarithmic axis of five decades, which shows
// tails.
Drawing draw_lobes(const std::vector<LobePanel>& panels, bool log);

}  // namespace lobe
