// SPDX-License-Identifier: Apache-2.0
// The scene as the device sees it. Lengths are in render space: the world moved to the median of
// its vertices and scaled by a power of two, so that every coordinate, the eye's too, lies in [-1,
// 1].
#ifndef LOBE_SHARED_TYPES_H
#define LOBE_SHARED_TYPES_H

#include "shared/layout.h"

#define LOBE_WIDTH 8  // children of a node, primitives of a leaf block

// A node of the eight-wide hierarchy: box planes by axis (lo x, hi x, lo y, hi y, lo z, hi z), one
// lane a child. An absent child has an empty box (lo = +inf, hi = -inf) and is never entered.
typedef struct LobeNode {
    float plane[6][LOBE_WIDTH];
    LobeUint child[LOBE_WIDTH];  // node index, or a leaf: see LOBE_LEAF_*
    LobeUint spare[LOBE_WIDTH];
} LobeNode;
LOBE_ASSERT_SIZE(LobeNode, 256);

// child = LOBE_LEAF | kind | (blocks - 1) << LOBE_LEAF_SHIFT | first block
#define LOBE_LEAF 0x80000000u
#define LOBE_LEAF_SPHERES 0x40000000u  // else triangles
#define LOBE_LEAF_SHIFT 28
#define LOBE_LEAF_BLOCKS 4  // most blocks in a leaf
#define LOBE_LEAF_INDEX 0x0fffffffu

// Eight triangles as a structure of arrays: vertex[corner][axis][lane]. An unused lane has NaN
// corners, which no ray hits, and primitive LOBE_NONE.
typedef struct LobeTriangleLeaf {
    float vertex[3][3][LOBE_WIDTH];
    LobeUint primitive[LOBE_WIDTH];
} LobeTriangleLeaf;
LOBE_ASSERT_SIZE(LobeTriangleLeaf, 320);

// Eight spheres. An unused lane has a NaN radius, which no ray hits, and primitive LOBE_NONE.
typedef struct LobeSphereLeaf {
    float centre[3][LOBE_WIDTH];
    float radius[LOBE_WIDTH];
    LobeUint primitive[LOBE_WIDTH];
} LobeSphereLeaf;
LOBE_ASSERT_SIZE(LobeSphereLeaf, 160);

// Primitives are numbered: triangles first, then spheres (primitive - triangle count).
typedef struct LobeTriangle {
    LobeUint v0, v1, v2, surface;
} LobeTriangle;
LOBE_ASSERT_SIZE(LobeTriangle, 16);

typedef struct LobeVertex {
    float px, py, pz, nx;  // position; unit normal, 0 where the surface has none
    float ny, nz, u, v;
} LobeVertex;
LOBE_ASSERT_SIZE(LobeVertex, 32);

typedef struct LobeSphere {
    float x, y, z, radius;
    LobeUint surface, pad0, pad1, pad2;
} LobeSphere;
LOBE_ASSERT_SIZE(LobeSphere, 32);

// What primitives of one shape share. Light of primitive p: first_light + (p - first_primitive).
typedef struct LobeSurface {
    LobeUint material, first_light, first_primitive, flags;
} LobeSurface;
LOBE_ASSERT_SIZE(LobeSurface, 16);
#define LOBE_SURFACE_NORMALS 1u  // vertices carry shading normals
#define LOBE_SURFACE_FLIPPED 2u  // the geometric normal points against the winding (or inwards)

// A material: which model (its place in LOBE_BRDFS) and its first row of parameters.
typedef struct LobeMaterial {
    LobeUint model, first_row, pad0, pad1;
} LobeMaterial;
LOBE_ASSERT_SIZE(LobeMaterial, 16);

// Room for a material as its model prepares it, in bytes; dispatch.h checks that every model fits.
#define LOBE_PREPARED_BYTES 512

// One parameter of a material: a colour in x, y, z; a number, integer or choice in x.
typedef struct LobeRow {
    float x, y, z, w;
} LobeRow;
LOBE_ASSERT_SIZE(LobeRow, 16);

#define LOBE_LIGHT_TRIANGLE 0u
#define LOBE_LIGHT_SPHERE 1u
#define LOBE_LIGHT_POINT 2u
#define LOBE_LIGHT_DISTANT 3u
#define LOBE_LIGHT_TWO_SIDED 1u
#define LOBE_LIGHT_FLIPPED 2u  // light leaves against the winding of the triangle (or inwards)
// Two triangles that make a flat quadrilateral are chosen as one, and then by their areas. They
// follow each other.
#define LOBE_LIGHT_FIRST_HALF 4u
#define LOBE_LIGHT_SECOND_HALF 8u

typedef struct LobeLight {
    LobeUint kind, primitive, flags;
    LobeUint place;         // in the tree below: LOBE_WIDTH * node + lane; LOBE_NONE: no tree
    float r, g, b, area;    // radiance; intensity of a point; irradiance of a distant light
    float x, y, z, radius;  // sphere centre; point position; unit direction towards a distant light
} LobeLight;
LOBE_ASSERT_SIZE(LobeLight, 48);

// A node of the tree over the lights, one lane a child; node 0 is the root. An absent child has no
// intensity.
typedef struct LobeLightNode {
    // A sphere about the child. Lights infinitely far away have the unit direction towards them as
    // centre, several a sphere of radius 2 about it, and `near` is 0 for them, else 1.
    float centre[3][LOBE_WIDTH], radius[LOBE_WIDTH], near[LOBE_WIDTH];
    float intensity[LOBE_WIDTH];  // luminance at unit distance, the most over directions
    // Normals of what shines, each into its half space, lie within a cone about a unit axis. Of
    // what shines everywhere the cosine of the cone's half angle is -2.
    float axis[3][LOBE_WIDTH], spread_cosine[LOBE_WIDTH], spread_sine[LOBE_WIDTH];
    LobeUint child[LOBE_WIDTH];  // node, or LOBE_LEAF | light (the first half of two)
    LobeUint parent, pad[7];     // place of the node itself, as LobeLight::place
} LobeLightNode;
LOBE_ASSERT_SIZE(LobeLightNode, 416);

#endif
