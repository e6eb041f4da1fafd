// SPDX-License-Identifier: Apache-2.0
// The rational lobe g(t) = t / (n - (n-1) t) on t in [0, 1]: its value, its integrals and the
// inverse of its distribution. Formulas: a = n - 1, x = 1 - t, so g = t / (t + n x).
#ifndef LOBE_BRDF_RATIONAL_LOBE_H
#define LOBE_BRDF_RATIONAL_LOBE_H

#include "brdf/lobe.h"

// Below this the lobe is so flat that samples uniform in t serve as well; the inversion's
// intermediate values grow as 1/n there.
#define RATIONAL_FLAT R(0.05)

// g at a point; the sum t + n x never cancels, unlike n - (n-1) t.
real rational_lobe(real n, LobePoint p) { return p.t > 0 ? p.t / fma(n, p.x, p.t) : 0; }

typedef struct {
    real j;  // integral of g over t
    real k;  // integral of t g over t
} RationalMoments;

// J = (n ln n - a) / a^2 and K = (n J - 1/2) / a cancel near n = 1. There, with positive terms
// only: for n <= 1, v = 1 - n, J = sum v^i / ((i+1)(i+2)), K = sum 2 v^i / ((i+1)(i+2)(i+3));
// for n > 1, v = 1 - 1/n, n J = sum v^i / (i+2), n K = sum v^i / (i+3).
RationalMoments rational_moments(real n) {
    RationalMoments m;
    real a = n - 1;
    if (n > R(0.4) && n < R(2.5)) {
        real v = n > 1 ? a / n : -a;
        m.j = 0;
        m.k = 0;
        for (int i = LOBE_DOUBLE ? 68 : 30; i >= 0; --i) {
            real below = n > 1 ? (real)(i + 2) : (real)((i + 1) * (i + 2));
            m.j = fma(m.j, v, 1 / below);
            m.k = fma(m.k, v, n > 1 ? 1 / (real)(i + 3) : 2 / (below * (i + 3)));
        }
        if (n > 1) {
            m.j /= n;
            m.k /= n;
        }
        return m;
    }
    real n_log = n > 0 ? n * (real_log(n) / a) : 0;  // n ln n / a without overflow
    m.j = (n_log - 1) / a;
    m.k = (n * m.j - R(0.5)) / a;
    return m;
}

// The point with G(x) = u J, where G is the integral of g from the peak: y = 1 + a x solves
// n ln y - y + 1 = u a^2 J. Solved without a loop in three regions:
//
// (1) u < 0.1, near the peak: one Newton step for s = ln y from the series s = a u J (1 + u J / 2).
// Else y = n e^-w, w - 1 + e^-w = d = (1 - u) a^2 J / n, one equation for all n (a branch of
// Lambert's W). With s = sign(a) sqrt(2 d):
// (2) |s| <= 1.8: e^-w = 1 - s Q(s), hence t = n (1 - e^-w) / a = sqrt(2 n J (1 - u)) Q(s);
// (3) s > 1.8: e^-w = T(e^-(d+1)), T(q) = q + q^2 + 3/2 q^3 + ..., the tree function;
// (4) s < -1.8 (n < 1/4): Newton steps for Y = e^-w in Y - 1 - ln Y = d.
// Q and T are minimax polynomials (Remez, 40 digits), relative error 3.4e-9 and 2e-10.
real rational_q(real s) {
    real q = fma(R(6.30672696495289356e-8), s, R(2.68460452154221749e-7));
    q = fma(q, s, R(-1.74892330526783222e-7));
    q = fma(q, s, R(-5.11015459003684391e-6));
    q = fma(q, s, R(-2.56733477511710267e-5));
    q = fma(q, s, R(-5.85349736582528257e-5));
    q = fma(q, s, R(2.31598445909620065e-4));
    q = fma(q, s, R(3.70357432619170458e-3));
    q = fma(q, s, R(2.77777422271763681e-2));
    q = fma(q, s, R(-0.333333314560865779));
    return fma(q, s, R(1.00000000172150723));
}

real rational_tree(real q) {
    real t = fma(R(43.1583657222826), q, R(8.57019903323847878));
    t = fma(t, q, R(5.32460877217629233));
    t = fma(t, q, R(2.66367042822809096));
    t = fma(t, q, R(1.50003511771793113));
    t = fma(t, q, R(0.999999863682121234));
    return fma(q * q, t, q);
}

// Region 1. All terms are divided by a, so that they stay near one for n up to 3e38.
LobePoint rational_near_peak(real n, real a, real j, real u) {
    LobePoint p;
    real target = u * j;
    if (fabs(a) < R(1e-3)) {  // a -> 0: z = s / a solves z - z^2 (1/2 + a z / 6) = u J
        real z = 2 * target / (1 + sqrt(1 - 2 * target));
        z = fma(a * z * z / (6 - 6 * z), z, z);
        p.x = z * fma(R(0.5) * a * z, fma(a, z / 3, 1), 1);
        p.t = 1 - p.x;
        return p;
    }
    real s = a * target * fma(R(0.5), target, 1);
    real e = real_expm1(s);
    real f = fabs(s) < R(0.05) ? s - s * s * fma(s, fma(s, R(1.0) / 24, R(1.0) / 6), R(0.5)) / a
                               : n / a * s - e / a;
    f -= a * target;
    p.x = real_expm1(s - f / (1 - e / a)) / a;
    p.t = 1 - p.x;
    return p;
}

LobePoint rational_invert(real n, real a, real j, real u) {
    if (n < RATIONAL_FLAT) return lobe_uniform_point(u);
    if (u < R(0.1)) return rational_near_peak(n, a, j, u);
    LobePoint p;
    real d = (1 - u) * (a * j) * (a / n);
    if (d <= R(1.62)) {
        real s = copysign(sqrt(2 * d), a);
        p.t = smaller(sqrt(2 * (1 - u) * (n * j)) * rational_q(s), 1);
        p.x = 1 - p.t;
    } else if (a > 0) {
        real fall = rational_tree(real_exp(-1 - d));
        p.t = n / a * (1 - fall);
        p.x = fma(n, fall, -1) / a;
    } else {
        real y = 1 + d + real_log(1 + d + real_log(1 + d));
        for (int i = 0; i < 2; ++i) y = (d + real_log(y)) * y / (y - 1);
        p.t = n / a * (1 - y);
        p.x = 1 - p.t;
    }
    return p;
}

#endif
