// SPDX-License-Identifier: Apache-2.0
// Reflectance in the plane of incidence, from the device: its values, and the lobe that stands out.
//
// Angles are in radians from the normal; those of light are positive on the far side, where the
// mirror direction is, and negative on the viewer's.
#pragma once

#include <optional>
#include <vector>

#include "lab/brdf_probe.h"

namespace lobe {

struct PlaneView {
    std::uint32_t set;  // of the probe's parameters
    double view;        // angle of the viewer
};

struct PlanePoint {
    PlaneView from;
    double light;
};

// The lobe is what rises over the least value in the plane. Its peak is sought up to 89 degrees
// from the normal: beyond, the values of many a model go to infinity.
struct PlaneLobe {
    double peak = 0, base = 0;           // luminance of f, 1/sr
    double at = 0;                       // angle of light at the peak
    bool any = false;                    // whether anything rises at all
    std::optional<double> below, above;  // from the peak to half its rise, on either side

    // The mean of both sides, or the one there is.
    std::optional<double> half_width() const;
};

class Plane {
  public:
    // The viewer stands at this azimuth. Keep the probe while using it.
    explicit Plane(const BrdfProbe& probe, double azimuth = 0) : probe_(probe), azimuth_(azimuth) {}

    glm::dvec3 viewer(double angle) const;
    glm::dvec3 light(double angle) const { return viewer(-angle); }

    // f in 1/sr, not times a cosine.
    std::vector<glm::dvec3> values(const std::vector<PlanePoint>& points) const;
    // Their luminance.
    std::vector<double> luminances(const std::vector<PlanePoint>& points) const;

    // The lobes of all views at once. Sharp ones are found where models have them: about the
    // directions of the mirror and of the viewer, at the normal, and where the model itself sends
    // samples.
    std::vector<PlaneLobe> lobes(const std::vector<PlaneView>& views) const;

    // How far from the peak, above (side 1) or below it (-1), the lobe has first fallen to `part`
    // of its rise, for each view; nothing where it does not before the horizon.
    std::vector<std::optional<double>> fallen_to(double part, int side,
                                                 const std::vector<PlaneView>& views,
                                                 const std::vector<PlaneLobe>& lobes) const;

    // Angles of light at which a curve of this view is well drawn, sorted.
    static std::vector<double> angles(double view);

  private:
    std::vector<double> sampled_angles(const PlaneView& view) const;
    void sharpen(const std::vector<PlaneView>& views, std::vector<PlaneLobe>& lobes) const;

    const BrdfProbe& probe_;
    double azimuth_;
};

// The last direction above the horizon that is asked for, as an angle from the normal.
extern const double grazing;

}  // namespace lobe
