// SPDX-License-Identifier: Apache-2.0
// The scene's buffers, by the part of the path tracer that reads them.
#ifndef LOBE_PATH_SCENE_H
#define LOBE_PATH_SCENE_H

#include "brdf/brdf.h"
#include "geom/ray.h"
#include "geom/surface.h"
#include "light/light.h"
#include "shared/frame.h"

#define LOBE_ROULETTE_DEPTH 2u  // scattering events before a path may be ended by chance

typedef struct {
    Geometry geometry;
    Shapes shapes;
    Lights lights;
    global const LobeMaterial* materials;
    global const uchar* prepared;  // LOBE_PREPARED_BYTES a material
    LobeTables tables;             // measured reflectance
} Scene;

#endif
