// SPDX-License-Identifier: Apache-2.0
// Choosing among several lights by what each could bring to a point: a tree of bounds over them, by
// A. Conty Estevez and C. Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting",
// 2018, here with eight children a node and without splitting. What a node is thought to bring is
// never zero if one of its lights brings something.
#ifndef LOBE_LIGHT_LIGHT_TREE_H
#define LOBE_LIGHT_LIGHT_TREE_H

#include "core/vec.h"
#include "geom/lanes.h"
#include "shared/types.h"

typedef struct {
    global const LobeLight* lights;
    global const LobeLightNode* nodes;
    uint count;
    uint root;  // as LobeLightNode::child
} Lights;

// What may be lit: a point, and the unit normal on the side from which it is seen.
typedef struct {
    real3 point, normal;
} Receiver;

// The most that the children of a node could bring to a receiver if all of each were at its middle,
// in a common unit. The cosines at either end are those of the middle, made larger by what a move
// of the child's radius can change: zero only where no light of the child can reach.
real8 light_importance(global const LobeLightNode* node, const Receiver* receiver) {
    real3 p = receiver->point, n = receiver->normal;
    real8 near = load_lanes(node->near), radius = load_lanes(node->radius);
    real8 x = fma(-near, (real8)(p.x), load_lanes(node->centre[0]));
    real8 y = fma(-near, (real8)(p.y), load_lanes(node->centre[1]));
    real8 z = fma(-near, (real8)(p.z), load_lanes(node->centre[2]));
    real8 d2 = fma(x, x, fma(y, y, z * z));
    real8 d = sqrt(d2);
    real8 arriving = fma(x, (real8)(n.x), fma(y, (real8)(n.y), z * n.z));
    real8 along = -fma(x, load_lanes(node->axis[0]),
                       fma(y, load_lanes(node->axis[1]), z * load_lanes(node->axis[2])));
    real8 across = sqrt(larger8(d2 - along * along, (real8)(0)));
    real8 spread = load_lanes(node->spread_cosine);
    // The best of the normals: turned from the axis towards the receiver.
    real8 turned = fma(along, spread, across * load_lanes(node->spread_sine));
    real8 leaving = along >= spread * d ? d : turned;
    real8 inverse = 1 / larger8(larger8(d, radius), (real8)(R(1e-15)));
    arriving = smaller8((arriving + radius) * inverse, (real8)(1));
    leaving = smaller8((leaving + radius) * inverse, (real8)(1));
    return load_lanes(node->intensity) * larger8(arriving, (real8)(0)) *
           larger8(leaving, (real8)(0)) * inverse * inverse;
}

real sum_of_lanes(real8 x) {
    real4 pairs = x.even + x.odd;
    real2 fours = pairs.even + pairs.odd;
    return fours.x + fours.y;
}

// The lane in whose part of [0, 1) u lies if each has a part as large as its weight, and its
// share of the weights, 0 if there are none. `u` becomes its place within that part.
uint choose_lane(real8 weights, real* u, real* share) {
    real weight[LOBE_WIDTH], pair[LOBE_WIDTH / 2];
    real4 pairs = weights.even + weights.odd;
    real2 fours = pairs.even + pairs.odd;
    vstore8(weights, 0, weight);
    vstore4(pairs, 0, pair);
    real total = fours.x + fours.y, rest = *u * total;
    uint lane = 0;
    if (rest >= fours.x) {
        rest -= fours.x;
        lane = 4;
    }
    if (rest >= pair[lane / 2]) {
        rest -= pair[lane / 2];
        lane += 2;
    }
    if (rest >= weight[lane]) {
        rest -= weight[lane];
        lane += 1;
    }
    // Rounding may lead past the last lane of weight.
    for (uint i = 0; i < LOBE_WIDTH && !(weight[lane] > 0); ++i) lane = i;
    *share = total > 0 ? weight[lane] / total : 0;
    *u = smaller(rest / weight[lane], 1 - REAL_EPSILON);
    return lane;
}

// Part of the area of a flat pair of triangles that the light, one of its halves, has.
real part_of_pair(const Lights* lights, uint light) {
    uint flags = lights->lights[light].flags;
    uint other = flags & LOBE_LIGHT_FIRST_HALF ? light + 1 : light - 1;
    real area = lights->lights[light].area;
    return area / (area + lights->lights[other].area);
}

// A light for a receiver, and the probability of its being chosen: 0 if no light reaches it.
uint choose_light(const Lights* lights, const Receiver* receiver, real u, real* probability) {
    *probability = 1;
    if (!LOBE_HAS_MANY_LIGHTS || lights->count == 1) return 0;
    uint child = lights->root;
    while (!(child & LOBE_LEAF)) {
        global const LobeLightNode* node = &lights->nodes[child];
        real share;
        uint lane = choose_lane(light_importance(node, receiver), &u, &share);
        *probability *= share;
        if (!(share > 0)) return 0;
        child = node->child[lane];
    }
    uint light = child & LOBE_LEAF_INDEX;
    if (!(lights->lights[light].flags & LOBE_LIGHT_FIRST_HALF)) return light;
    real first = part_of_pair(lights, light);
    *probability *= u < first ? first : 1 - first;
    return u < first ? light : light + 1;
}

// Probability with which choose_light takes a light for the receiver.
real light_probability(const Lights* lights, const Receiver* receiver, uint light) {
    if (!LOBE_HAS_MANY_LIGHTS || lights->count == 1) return 1;
    uint halves = LOBE_LIGHT_FIRST_HALF | LOBE_LIGHT_SECOND_HALF;
    real probability = lights->lights[light].flags & halves ? part_of_pair(lights, light) : 1;
    uint place = lights->lights[light].place;
    while (place != LOBE_NONE) {
        global const LobeLightNode* node = &lights->nodes[place / LOBE_WIDTH];
        real8 weights = light_importance(node, receiver);
        real weight[LOBE_WIDTH];
        vstore8(weights, 0, weight);
        if (!(weight[place % LOBE_WIDTH] > 0)) return 0;
        probability *= weight[place % LOBE_WIDTH] / sum_of_lanes(weights);
        place = node->parent;
    }
    return probability;
}

#endif
