// SPDX-License-Identifier: Apache-2.0
// Lafortune: f = kd + sum over three lobes of ks (cxy (wi.x wo.x + wi.y wo.y) + cz wi.z wo.z)^n,
// 0 where the bracket is negative.
// Source: E. P. F. Lafortune, S.-C. Foo, K. E. Torrance, D. P. Greenberg, "Non-linear approximation
// of reflectance functions", SIGGRAPH 1997, with Cx = Cy and a factor ks of its own for each lobe.
//
// cxy = -1, cz = 1 is modified Phong; cxy = cz = 1 reflects back; cz smaller than -cxy leans off
// the mirror direction to grazing angles; cxy = 0 is Minnaert's cosines. A factor s in both of a
// lobe is one of s^n in its ks: so both stay within [-1, 1], and published fits beyond are given
// scaled. A lobe of ks = 0 is left out, and so is one of n = infinity: it has no energy.
//
// Reciprocal. Conserves energy where pi kd + sum of 2 pi ks max(|cxy|, |cz|)^n / (n + 2) <= 1; the
// sum is the albedo at normal incidence if all cz >= |cxy|, else a bound: a lobe is (|D| cos)^n
// about D = (cxy wo.x, cxy wo.y, cz wo.z), and no cosine lobe reflects more than one about the
// normal.
//
// Sampling: diffuse part and lobes about by albedo; a lobe by cos^n about D, restricted to what is
// above the horizon if D points below, azimuth over the visible arc.
#ifndef LOBE_BRDF_LAFORTUNE_H
#define LOBE_BRDF_LAFORTUNE_H

#include "brdf/arc.h"
#include "brdf/cosine_power.h"
#include "core/warp.h"

// clang-format off
#define lafortune_parameters(P) \
    P(color, kd, 0.25, 0, inf, "diffuse part, 1/sr") \
    P(color, ks1, 0.25, 0, inf, "first lobe, 1/sr") \
    P(number, cxy1, -1, -1, 1, "its factor along the surface: -1 mirrors, 1 reflects back") \
    P(number, cz1, 1, -1, 1, "its factor along the normal") \
    P(number, n1, 20, 0, inf, "its exponent") \
    P(color, ks2, 0, 0, inf, "second lobe, 1/sr") \
    P(number, cxy2, -0.9, -1, 1, "its factor along the surface") \
    P(number, cz2, 0.7, -1, 1, "its factor along the normal") \
    P(number, n2, 20, 0, inf, "its exponent") \
    P(color, ks3, 0, 0, inf, "third lobe, 1/sr") \
    P(number, cxy3, 0.9, -1, 1, "its factor along the surface") \
    P(number, cz3, 0.9, -1, 1, "its factor along the normal") \
    P(number, n3, 20, 0, inf, "its exponent")
// clang-format on
LOBE_BRDF_VALUES(lafortune)

#define LAFORTUNE_LOBES 3

typedef struct {
    real3 ks;
    real cxy, cz, n;
    real albedo;   // mean albedo if C wo were the normal; 0: no lobe
    real grazing;  // part of it that is left where C wo lies in the surface
} LafortuneLobe;

typedef struct {
    LafortuneLobe lobe[LAFORTUNE_LOBES];
    real3 kd;
    real diffuse;  // mean albedo
} lafortune_prepared;

LafortuneLobe lafortune_lobe(real3 ks, real cxy, real cz, real n) {
    LafortuneLobe l;
    l.ks = ks;
    l.cxy = cxy;
    l.cz = cz;
    l.n = smaller(n, LOBE_LARGEST_N);
    l.albedo = n > LOBE_LARGEST_N ? 0 : mean_component(ks) * (REAL_TWO_PI / (l.n + 2));
    l.grazing = R(0.5) / sqrt(fma(R(1.57), l.n, 1));  // as in modified_phong.h
    return l;
}

lafortune_prepared lafortune_prepare(lafortune_values values) {
    lafortune_prepared m;
    m.lobe[0] = lafortune_lobe(values.ks1, values.cxy1, values.cz1, values.n1);
    m.lobe[1] = lafortune_lobe(values.ks2, values.cxy2, values.cz2, values.n2);
    m.lobe[2] = lafortune_lobe(values.ks3, values.cxy3, values.cz3, values.n3);
    m.kd = values.kd;
    m.diffuse = REAL_PI * mean_component(m.kd);
    return m;
}

int lafortune_claims(lafortune_values values) {
    lafortune_prepared m = lafortune_prepare(values);
    real3 albedo = REAL_PI * m.kd;
    for (int i = 0; i < LAFORTUNE_LOBES; ++i) {
        LafortuneLobe l = m.lobe[i];
        real longest = larger(fabs(l.cxy), fabs(l.cz));
        if (l.albedo > 0) albedo += l.ks * (REAL_TWO_PI / (l.n + 2) * real_power(longest, l.n));
    }
    return LOBE_BRDF_RECIPROCAL | LOBE_BRDF_KEEPS_SAMPLES | LOBE_BRDF_CONSERVES_BELOW(albedo);
}

real3 lafortune_formula_lobe(real3 ks, real cxy, real cz, real n, real3 wo, real3 wi) {
    real product = cxy * (wi.x * wo.x + wi.y * wo.y) + cz * (wi.z * wo.z);
    return product > 0 ? ks * pow(product, n) : (real3)(0);
}

real3 lafortune_formula(lafortune_values values, real3 wo, real3 wi) {
    return values.kd +
           lafortune_formula_lobe(values.ks1, values.cxy1, values.cz1, values.n1, wo, wi) +
           lafortune_formula_lobe(values.ks2, values.cxy2, values.cz2, values.n2, wo, wi) +
           lafortune_formula_lobe(values.ks3, values.cxy3, values.cz3, values.n3, wo, wi);
}

// The bracket t and x = 1 - t. With unit vectors, 2 a.b = a^2 + b^2 - (a - b)^2 in plane and normal
// turns x into a sum of nothing negative, the same for both orders of the directions.
LobePoint lafortune_product(const LafortuneLobe* l, real3 wo, real3 wi) {
    LobePoint p;
    real2 across = l->cxy > 0 ? wo.xy - wi.xy : wo.xy + wi.xy;
    real along = l->cz > 0 ? wo.z - wi.z : wo.z + wi.z;
    real a = fabs(l->cxy), b = fabs(l->cz);
    real twice = a * dot(across, across) + b * (along * along);
    twice += (1 - a) * (dot(wo.xy, wo.xy) + dot(wi.xy, wi.xy));
    twice += (1 - b) * (wo.z * wo.z + wi.z * wi.z);
    p.x = R(0.5) * twice;
    p.t = p.x < R(0.5) ? 1 - p.x : l->cxy * dot(wo.xy, wi.xy) + l->cz * (wo.z * wi.z);
    return p;
}

// Where a lobe points, seen from wo.
typedef struct {
    real3 axis;       // D / |D|
    real log_length;  // ln |D|
    real log_top;     // ln of the largest visible cosine to the axis
    real share;       // of the samples; until divided by the sum, about the lobe's albedo
} LafortuneAim;

LafortuneAim lafortune_aim(const LafortuneLobe* l, real3 wo) {
    LafortuneAim aim;
    real3 d = (real3)(l->cxy * wo.x, l->cxy * wo.y, l->cz * wo.z);
    real longest = largest_component(fabs(d));
    aim.share = 0;
    if (l->albedo == 0 || longest == 0) return aim;
    real3 scaled = d / longest;
    real length = sqrt(dot(scaled, scaled));
    // 1 - |D|^2 from the parts, so that a D of length 1 is exact
    real rest = (1 - l->cxy * l->cxy) * dot(wo.xy, wo.xy) + (1 - l->cz * l->cz) * (wo.z * wo.z);
    real x = rest / (1 + longest * length);
    aim.axis = x < R(0.5) ? d / (1 - x) : scaled / length;
    aim.log_length = x < R(0.5) ? real_log1p(-x) : real_log(longest) + real_log(length);
    aim.log_top = aim.axis.z < 0 ? R(0.5) * real_log1p(-aim.axis.z * aim.axis.z) : 0;
    real visible = fma(1 - l->grazing, larger(aim.axis.z, 0), l->grazing);
    // A lobe that points below the horizon keeps about (largest cosine)^(n + 2) of a grazing one.
    real power = fma(l->n, aim.log_length, (l->n + 2) * aim.log_top);
    aim.share = l->albedo * visible * real_exp(power);
    return aim;
}

// Shares of the samples; the last is the diffuse part's. Returns 0 if there is nothing to sample.
int lafortune_aims(const lafortune_prepared* m, real3 wo, LafortuneAim* aims, real* diffuse) {
    real total = m->diffuse;
    for (int i = 0; i < LAFORTUNE_LOBES; ++i) {
        aims[i] = lafortune_aim(&m->lobe[i], wo);
        total += aims[i].share;
    }
    if (!(total > 0)) return 0;
    for (int i = 0; i < LAFORTUNE_LOBES; ++i) aims[i].share /= total;
    *diffuse = m->diffuse / total;
    return 1;
}

// Density of a lobe's samples at wi, p the angle to its axis.
real lafortune_density(const LafortuneLobe* l, const LafortuneAim* aim, LobePoint p, real3 wi) {
    if (!(p.t > 0)) return 0;
    real power = fma(l->n, real_log_split(p.t, p.x) - aim->log_top, -aim->log_top);
    real density = (l->n + 1) * REAL_INV_TWO_PI * real_exp(power);
    real side = aim->axis.x * wi.y - aim->axis.y * wi.x;
    density /= arc_through(wi, p, aim->axis, side);
    return smaller(aim->share * density, LOBE_LARGEST_N);
}

real3 lafortune_eval(const lafortune_prepared* m, real3 wo, real3 wi) {
    real3 f = m->kd;
    for (int i = 0; i < LAFORTUNE_LOBES; ++i) {
        LafortuneLobe l = m->lobe[i];
        if (l.albedo > 0) f += l.ks * cosine_power(l.n, lafortune_product(&l, wo, wi));
    }
    return f * wi.z;
}

real lafortune_pdf(const lafortune_prepared* m, real3 wo, real3 wi) {
    LafortuneAim aims[LAFORTUNE_LOBES];
    real diffuse;
    if (!lafortune_aims(m, wo, aims, &diffuse)) return 0;
    real pdf = diffuse * wi.z * REAL_INV_PI;
    for (int i = 0; i < LAFORTUNE_LOBES; ++i)
        if (aims[i].share > 0)
            pdf += lafortune_density(&m->lobe[i], &aims[i],
                                     lobe_point(reflect_local(aims[i].axis), wi), wi);
    return pdf;
}

// The part of the shares that u falls into, or the number of lobes for the diffuse part.
int lafortune_pick(const LafortuneAim* aims, real diffuse, real u) {
    int pick = LAFORTUNE_LOBES;
    real edge = 0;
    for (int i = 0; i < LAFORTUNE_LOBES; ++i) {
        if (aims[i].share > 0 && u >= edge) pick = i;
        edge += aims[i].share;
    }
    return diffuse > 0 && u >= edge ? LAFORTUNE_LOBES : pick;
}

BrdfSample lafortune_sample(const lafortune_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    LafortuneAim aims[LAFORTUNE_LOBES];
    real diffuse;
    if (!lafortune_aims(m, wo, aims, &diffuse)) return sample;
    int pick = lafortune_pick(aims, diffuse, u.z);
    LobePoint drawn;
    if (pick < LAFORTUNE_LOBES) {
        LafortuneAim aim = aims[pick];
        real log_t = aim.log_top + real_log1p(-u.x) / (m->lobe[pick].n + 1);
        drawn.x = -real_expm1(log_t);
        drawn.t = drawn.x < R(0.5) ? 1 - drawn.x : real_exp(log_t);
        real turns = visible_arc(drawn, aim.axis) * (u.y - R(0.5));
        sample.wi = lobe_direction(reflect_local(aim.axis), drawn, turns);
    } else {
        sample.wi = cosine_hemisphere(u.xy);
    }
    if (!(sample.wi.z > 0)) return brdf_no_sample();
    sample.pdf = diffuse * sample.wi.z * REAL_INV_PI;
    real3 f = m->kd;
    for (int i = 0; i < LAFORTUNE_LOBES; ++i) {
        if (!(aims[i].share > 0)) continue;
        LafortuneLobe l = m->lobe[i];
        LobePoint p = i == pick ? drawn : lobe_point(reflect_local(aims[i].axis), sample.wi);
        if (p.t > 0) f += l.ks * real_exp(l.n * (aims[i].log_length + real_log_split(p.t, p.x)));
        sample.pdf += lafortune_density(&l, &aims[i], p, sample.wi);
    }
    if (!(sample.pdf > 0)) return brdf_no_sample();
    sample.weight = f * (sample.wi.z / sample.pdf);
    return sample;
}

#endif
