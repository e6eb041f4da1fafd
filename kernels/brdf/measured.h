// SPDX-License-Identifier: Apache-2.0
// Measured: f = scale * table(theta_h, theta_d, phi_d), trilinear between the cells of a file.
// Sources: W. Matusik et al., "A data-driven reflectance model", 2003 (the table and its spacing);
// S. Rusinkiewicz, "A new change of variables for efficient BRDF representation", 1998 (angles).
//
// theta_h lies between normal and half vector, theta_d between half vector and either direction,
// phi_d is the turn of wi about the half vector. Cells are even in sqrt(theta_h), theta_d and
// phi_d; a value is that of its cell's middle. At the ends of theta_h and theta_d it goes on as it
// is.
//
// Reciprocal, as phi_d has a period of half a turn. Nothing is claimed of energy: what a file holds
// is not known here. Sampling: the half vector by what the table reflects at each theta_h, which is
// tabulated too, beside a cosine; what goes below the horizon is lost.
#ifndef LOBE_BRDF_MEASURED_H
#define LOBE_BRDF_MEASURED_H

#include "brdf/brdf.h"
#include "core/math.h"
#include "core/warp.h"

// clang-format off
#define measured_parameters(P) \
    P(table, filename, 0, 0, 0, "file of measured reflectance: MERL's binary layout or lobe's text") \
    P(color, scale, 1, 0, 1000, "factor of the measured values")
// clang-format on
LOBE_BRDF_VALUES(measured)

// What a table holds (host/scene/measured_layout.cpp writes it): counts of theta_h, theta_d, phi_d;
// the cosine's share of the samples; for each of counts.x + 2 nodes of the sampling density, at 0,
// at the middles of the cells of theta_h and at 90 degrees, MEASURED_NODE numbers: 1 - cos theta_h,
// the density per 1 - cos theta_h, linear between nodes, and its integral up to here; then three
// channels a cell, phi_d running fastest and theta_h slowest.
#define MEASURED_HEADER 4
#define MEASURED_NODE 3

typedef struct {
    LobeTables tables;
    uint first;
    real3 scale;
} measured_prepared;

measured_prepared measured_prepare(measured_values values) {
    measured_prepared m;
    m.tables = 0;
    m.first = values.filename;
    m.scale = values.scale;
    return m;
}

int measured_claims(measured_values values) {
    return LOBE_BRDF_RECIPROCAL | (is_black(values.scale) ? LOBE_BRDF_CONSERVES_ENERGY : 0);
}

global const float* measured_table(const measured_prepared* m) { return m->tables + m->first; }

// The half vector times twice the cosine of theta_d, and that length. Opposite grazing directions
// have none: the smallest number stands in for it.
typedef struct {
    real3 sum;
    real length;
} MeasuredHalf;

MeasuredHalf measured_half(real3 wo, real3 wi) {
    MeasuredHalf halfway;
    halfway.sum = wo + wi;
    halfway.length = sqrt(dot(halfway.sum, halfway.sum) + R(1e-36));
    return halfway;
}

// theta_h, theta_d and phi_d as the table spaces them, each from 0 to 1. No angle comes from its
// cosine: with s = wo + wi and e = wi - wo, tan theta_h = |s.xy| / s.z, tan theta_d = |e| / |s|,
// and e's parts across and along the plane of normal and half vector give phi_d. Exchanging the
// directions turns both of these round and changes no bit of the rest.
real3 measured_angles(const MeasuredHalf* halfway, real3 wo, real3 wi) {
    real3 s = halfway->sum, e = wi - wo;
    real lean = s.x * s.x + s.y * s.y;
    real along = s.z * (s.x * e.x + s.y * e.y) - lean * e.z;
    real across = halfway->length * (s.x * e.y - s.y * e.x);
    real turns = along != 0 || across != 0 ? real_angle(fabs(across), fabs(along)) : 0;
    int obtuse = (along < 0) != (across < 0);
    real theta_h = real_angle(sqrt(lean), s.z);
    real theta_d = real_angle(sqrt(dot(e, e)), halfway->length);
    return (real3)(sqrt(4 * theta_h), 4 * theta_d, obtuse ? 1 - 2 * turns : 2 * turns);
}

// The cells on either side of a coordinate, and the second one's part.
typedef struct {
    int low, high;
    real part;
} MeasuredCells;

MeasuredCells measured_cells(real at, int count, int periodic) {
    MeasuredCells cells;
    real middle = at * count - R(0.5);
    real below = floor(middle);
    cells.part = middle - below;
    cells.low = clamp(convert_int_sat(below), -1, count - 1);
    cells.high = cells.low + 1;
    if (cells.low < 0) cells.low = periodic ? count - 1 : 0;
    if (cells.high == count) cells.high = periodic ? 0 : count - 1;
    return cells;
}

// Between two cells of phi_d, in the row that begins at `row`.
real3 measured_row(global const float* row, MeasuredCells phi) {
    global const float *a = row + 3 * phi.low, *b = row + 3 * phi.high;
    real other = 1 - phi.part;
    return (real3)(other * a[0] + phi.part * b[0], other * a[1] + phi.part * b[1],
                   other * a[2] + phi.part * b[2]);
}

real3 measured_value(const measured_prepared* m, const MeasuredHalf* halfway, real3 wo, real3 wi) {
    global const float* table = measured_table(m);
    // At least one, so that a table of zeros is black.
    int3 count = max((int3)((int)table[0], (int)table[1], (int)table[2]), (int3)(1));
    real3 at = measured_angles(halfway, wo, wi);
    MeasuredCells h = measured_cells(at.x, count.x, 0);
    MeasuredCells d = measured_cells(at.y, count.y, 0);
    MeasuredCells phi = measured_cells(at.z, count.z, 1);
    global const float* values = table + MEASURED_HEADER + MEASURED_NODE * (count.x + 2);
    uint row = 3 * count.z;
    global const float* first = values + (uint)(h.low * count.y) * row;
    global const float* second = values + (uint)(h.high * count.y) * row;
    real3 low = (1 - d.part) * measured_row(first + (uint)d.low * row, phi) +
                d.part * measured_row(first + (uint)d.high * row, phi);
    real3 high = (1 - d.part) * measured_row(second + (uint)d.low * row, phi) +
                 d.part * measured_row(second + (uint)d.high * row, phi);
    return (1 - h.part) * low + h.part * high;
}

real3 measured_eval(const measured_prepared* m, real3 wo, real3 wi) {
    MeasuredHalf halfway = measured_half(wo, wi);
    return m->scale * measured_value(m, &halfway, wo, wi) * wi.z;
}

// The last node whose member `column` does not exceed `value`, but the last node of all.
global const float* measured_node(global const float* table, int column, real value) {
    int low = 0, high = (int)table[0] + 1;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (table[MEASURED_HEADER + MEASURED_NODE * middle + column] <= value) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return table + MEASURED_HEADER + MEASURED_NODE * low;
}

// Mirrored about a half vector of density p(1 - cos theta_h) / 2 pi, a direction has that density
// over 4 cos theta_d.
real measured_pdf(const measured_prepared* m, real3 wo, real3 wi) {
    global const float* table = measured_table(m);
    MeasuredHalf halfway = measured_half(wo, wi);
    real3 s = halfway.sum;
    real x =
        (s.x * s.x + s.y * s.y) / (halfway.length * (halfway.length + s.z));  // 1 - cos theta_h
    global const float* node = measured_node(table, 0, x);
    real part = (x - node[0]) / (node[MEASURED_NODE] - node[0]);
    real density = node[1] + smaller(part, 1) * (node[MEASURED_NODE + 1] - node[1]);
    real cosine = table[3];
    return cosine * wi.z * REAL_INV_PI +
           (1 - cosine) * density * REAL_INV_TWO_PI / (2 * halfway.length);
}

// 1 - cos theta_h where the integral of its density is u: within a node's piece the root of a
// parabola, in the form that does not cancel.
real measured_inverse(global const float* table, real u) {
    global const float* node = measured_node(table, 2, u);
    real width = node[MEASURED_NODE] - node[0], rise = node[MEASURED_NODE + 1] - node[1];
    real mass = u - node[2];
    real root = sqrt(larger(node[1] * node[1] + 2 * rise * mass / width, 0));
    real step = mass > 0 ? 2 * mass / (node[1] + root) : 0;
    return smaller(node[0] + step, node[MEASURED_NODE]);
}

BrdfSample measured_sample(const measured_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    global const float* table = measured_table(m);
    if (u.z < table[3]) {
        sample.wi = cosine_hemisphere(u.xy);
    } else {
        real x = measured_inverse(table, u.x);
        real2 around = sqrt(x * (2 - x)) * real_circle(u.y);
        real3 h = (real3)(around, 1 - x);
        sample.wi = 2 * dot(wo, h) * h - wo;
    }
    if (!(sample.wi.z > 0)) return brdf_no_sample();
    sample.pdf = measured_pdf(m, wo, sample.wi);
    if (!(sample.pdf > 0)) return brdf_no_sample();
    sample.weight = measured_eval(m, wo, sample.wi) / sample.pdf;
    return sample;
}

#endif
