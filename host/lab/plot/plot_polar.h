// SPDX-License-Identifier: Apache-2.0
// Polar plots of reflectance in the plane of incidence, a panel a model, a curve an angle of view.
#pragma once

#include <string>
#include <vector>

#include "lab/settings.h"
#include "report/drawing.h"

namespace lobe {

struct PolarCurve {
    double view;                     // radians
    std::vector<glm::dvec2> points;  // angle of light (radians) and f (1/sr)
};

struct PolarPanel {
    std::string title, subtitle;
    std::vector<PolarCurve> curves;
    double top = 0, typical = 0;  // of f over all curves: the highest peak, the median
};

// The model seen from these angles (degrees), the viewer at an azimuth (radians).
PolarPanel polar_panel(BrdfProbe& probe, const Subject& subject, const std::vector<double>& views,
                       double azimuth = 0);

enum class Scale { automatic, linear, log };

// On one radial scale where they are much the same, else each on its own; automatic is logarithmic
// where peaks are far above the rest.
Drawing draw_polar(const std::vector<PolarPanel>& panels, Scale scale = Scale::automatic);

}  // namespace lobe
