// SPDX-License-Identifier: Apache-2.0
// Fits a model's parameters to tabulated reflectance.
//
// Two residuals per direction pair and channel, c = sqrt(cos theta_i cos theta_o), the same seen
// from either side:
//     cos   c (f - g)                          what is reflected, so that bright peaks matter most
//     log   ln (e + c f) - ln (e + c g)        ratios, with e = 0.001 / sr: dark parts matter too
// f being the data (at least 0 in the logarithm) and g the model. Either is minimised, both are
// told.
#pragma once

#include <string>
#include <vector>

#include "lab/settings.h"
#include "scene/measured.h"

namespace lobe {

class Device;
class KernelText;

enum class FitWeight { cosine, logarithm };

struct FitOptions {
    FitWeight weight = FitWeight::cosine;
    std::size_t points = 20000;
    double largest_angle = 80;  // degrees from the normal
    int starts = 12;
    std::uint64_t seed = 1;
};

// Direction pairs and their f, 1/sr.
struct FitPoints {
    std::vector<glm::dvec3> wo, wi, f;
    std::size_t candidates = 0;  // of which they are chosen

    std::size_t size() const { return f.size(); }
};

// The middles of cells that have data and where both directions are within the largest angle from
// the normal; if these are too many, one drawn from each of as many equal runs in the table's
// order. So every region of angles counts by its number of cells: the peak, where they are dense,
// counts much. Throws Error (scene) if there are none.
FitPoints choose_points(const MeasuredBrdf& table, const FitOptions& options);

// A parameter that was fitted.
struct FittedParameter {
    std::string name;
    std::vector<double> value;           // one number, or three
    std::vector<double> standard_error;  // NaN: at its bound, without effect, or not determined
};

struct ModelFit {
    BrdfRows rows;
    std::vector<FittedParameter> parameters;
    double cosine_error = 0, log_error = 0;  // root mean square residuals: 1/sr, and a ratio's ln
    int iterations = 0;
    bool converged = false;
    double seconds = 0;
};

// The subject's colours and numbers but those that are `held`, by name; integers, choices and held
// ones keep the subject's values. From `starts` starts on a part of the points, the best two go on
// with all. Standard errors are those of least squares: from the Jacobian at the optimum and the
// residuals' variance, as if the model were true and residuals independent. Throws Error (usage) if
// nothing is left to fit or this build has no solver.
ModelFit fit_model(BrdfProbe& probe, const Subject& subject, const std::vector<std::string>& held,
                   const FitPoints& points, const FitOptions& options);

// Root mean square of the data: c f, what an error of the first kind compares with.
double size_of(const FitPoints& points);

}  // namespace lobe
