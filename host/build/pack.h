// SPDX-License-Identifier: Apache-2.0
// A scene made ready for the device: arrays of shared structs, and what the kernel must contain.
#pragma once

#include <string>
#include <vector>

#include "build/bvh.h"
#include "build/features.h"
#include "build/integrator.h"
#include "build/light_tree.h"
#include "build/placement.h"
#include "scene/scene.h"
#include "shared/frame.h"

namespace lobe {

// All that the kernel's text depends on.
struct KernelNeeds {
    FeatureSet features;
    Integrator integrator;
    std::vector<BrdfTable> models;  // a material's model is a place in this list
};

struct PackedScene : KernelNeeds {
    Placement placement;
    Bvh bvh;
    std::vector<LobeTriangle> triangles;
    std::vector<LobeVertex> vertices;
    std::vector<LobeSphere> spheres;
    std::vector<LobeSurface> surfaces;
    std::vector<LobeMaterial> materials;
    std::vector<LobeRow> rows;
    std::vector<float> tables;  // the scene's measured reflectance
    LightTree lights;
    std::vector<float> filter_nodes;
    LobeFrame frame;  // all but the launch's own rows and samples
};

struct PackOptions {
    std::vector<BrdfTable> models;  // all there are
    bool all_features = false;      // compile everything in, all models too
    Integrator integrator;
    std::vector<Feature> forced;  // compiled in, needed or not
    bool all_models = false;      // compile all models in, and only the features needed
};

// What pack_scene() of the same would need of the kernel, known long before.
KernelNeeds kernel_needs(const Scene& scene, const PackOptions& options = {});

// Throws Error (scene) for a film or a scene past what 32-bit indices can name, and Error
// (internal) for a material that has not one row for each parameter of its model. A model that
// `options` does not have is taken to be a file of lobe's, brdf/NAME.h.
PackedScene pack_scene(const Scene& scene, const PackOptions& options = {});

// Frees what the device has a copy of: shapes, their hierarchies, lights and tables.
void free_shapes(PackedScene& packed);

// The camera and film part of the frame, and the half widths of the filter.
LobeFrame pack_frame(const Scene& scene, const Placement& placement);

}  // namespace lobe
