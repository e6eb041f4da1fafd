// SPDX-License-Identifier: Apache-2.0
// The contract every reflectance model keeps. README.md beside this file explains it; here are the
// types and the macros that turn a model's parameter table into code.
#ifndef LOBE_BRDF_BRDF_H
#define LOBE_BRDF_BRDF_H

#include "core/vec.h"
#include "shared/types.h"

// What a model claims of itself for given parameters: NAME_claims gives a sum of these.
#define LOBE_BRDF_RECIPROCAL 1        // f(wo, wi) = f(wi, wo)
#define LOBE_BRDF_CONSERVES_ENERGY 2  // albedo at most 1, seen from the viewer and from the light
#define LOBE_BRDF_KEEPS_SAMPLES 4     // no sample is lost below the horizon: pdf integrates to 1

// The claim to conserve energy where no channel of the largest albedo passes 1 but by rounding.
#define LOBE_BRDF_CONSERVES_BELOW(albedo) \
    (largest_component(albedo) <= R(1.000001) ? LOBE_BRDF_CONSERVES_ENERGY : 0)

// The scene's tables of measured numbers. A model with a row of kind `table` keeps this pointer as
// the first member of its prepared form; its caller sets it. Such a row's value is the index of the
// table's first number.
typedef global const float* LobeTables;

// What NAME_sample gives: a direction in the shading frame, its density per solid angle, and the
// weight f |cos theta_i| / pdf. A weight of zero means "no sample". For a delta lobe, `delta` is
// set, pdf is the probability with which the lobe was chosen, and weight is its reflectance
// divided by that probability.
typedef struct {
    real3 wi;
    real pdf;
    real3 weight;
    int delta;
} BrdfSample;

BrdfSample brdf_no_sample(void) {
    BrdfSample sample;
    sample.wi = (real3)(0, 0, 1);
    sample.pdf = 0;
    sample.weight = (real3)(0);
    sample.delta = 0;
    return sample;
}

// A parameter table NAME_parameters(P) of rows P(kind, name, default, lowest, highest, meaning)
// becomes a struct NAME_values with one member a row, and a loader from rows of 16 bytes.
#define LOBE_MEMBER_color(name) real3 name;
#define LOBE_MEMBER_number(name) real name;
#define LOBE_MEMBER_integer(name) int name;
#define LOBE_MEMBER_choice(name) int name;
#define LOBE_MEMBER_table(name) uint name;
#define LOBE_MEMBER(kind, name, standard, lowest, highest, meaning) LOBE_MEMBER_##kind(name)

#define LOBE_LOAD_color(row) (real3)((row).x, (row).y, (row).z)
#define LOBE_LOAD_number(row) (row).x
#define LOBE_LOAD_integer(row) (int)(row).x
#define LOBE_LOAD_choice(row) (int)(row).x
#define LOBE_LOAD_table(row) as_uint((row).x)
#define LOBE_LOAD(kind, name, standard, lowest, highest, meaning) \
    values.name = LOBE_LOAD_##kind(*row);                         \
    ++row;

#define LOBE_TABLES_color 0
#define LOBE_TABLES_number 0
#define LOBE_TABLES_integer 0
#define LOBE_TABLES_choice 0
#define LOBE_TABLES_table 1
#define LOBE_TABLES(kind, name, standard, lowest, highest, meaning) +LOBE_TABLES_##kind

// Sets the tables of a prepared form `m` whose model has any.
#define LOBE_BRDF_ATTACH(NAME, m, tables) \
    if (NAME##_tables) *(LobeTables*)&m = tables;

#define LOBE_BRDF_VALUES(NAME)                                 \
    enum { NAME##_tables = 0 NAME##_parameters(LOBE_TABLES) }; \
    typedef struct {                                           \
        NAME##_parameters(LOBE_MEMBER)                         \
    } NAME##_values;                                           \
    NAME##_values NAME##_load(global const LobeRow* row) {     \
        NAME##_values values;                                  \
        NAME##_parameters(LOBE_LOAD) return values;            \
    }

#endif
