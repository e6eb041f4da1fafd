// SPDX-License-Identifier: Apache-2.0
// Elementary functions made of + - * / fma sqrt and integer operations only, so that they give the
// same bits on every device and cost a fraction of the builtins. In double they are the builtins.
//
// Coefficients: minimax polynomials by the Remez exchange in 40 digits, rounded to float; "fit"
// states the relative error that the polynomial alone adds (half an ulp is 6e-8).
// Angles are in turns (1 turn = 2 pi), whose reduction to one octant is exact.
#ifndef LOBE_CORE_MATH_H
#define LOBE_CORE_MATH_H

#include "core/real.h"

#if LOBE_DOUBLE

real real_exp(real x) { return exp(x); }
real real_expm1(real x) { return expm1(x); }
real real_log(real x) { return log(x); }
real real_log1p(real x) { return log1p(x); }
real real_log_split(real t, real x) { return x < 0.5 ? log1p(-x) : log(t); }
real2 real_circle(real turns) { return (real2)(cospi(2 * turns), sinpi(2 * turns)); }
real2 real_circle_octant(real turns) { return real_circle(turns); }
real real_angle(real y, real x) { return atan2pi(y, x) * 0.5; }

#else

#define REAL_LN2 0.69314718246459960938f  // ln 2 rounded up to float
#define REAL_LN2_REST -1.9046542e-9f      // what that is too much
#define REAL_LOG2_E 1.44269504088896340736f
#define REAL_ROUNDER 12582912.0f         // 1.5 * 2^23: adding it rounds to an integer
#define REAL_TWO_PI_REST -1.7484555e-7f  // 2 pi less its float
#define REAL_BIG_X 89.0f                 // exp overflows before this
#define REAL_TINY_X -104.0f              // exp rounds to 0 from here on

// exp(x) = 2^k (1 + p) for |x| <= 104: gives p in [-0.3, 0.42] and k. Fit of p: 1.4e-8.
real real_exp_parts(real x, int* k) {
    real rounded = fma(x, REAL_LOG2_E, REAL_ROUNDER);
    *k = as_int(rounded) - as_int(REAL_ROUNDER);
    rounded -= REAL_ROUNDER;
    real r = fma(rounded, -REAL_LN2, x);
    r = fma(rounded, -REAL_LN2_REST, r);
    real q = 0.00139464339347328826f;
    q = fma(q, r, 0.00836658532862942466f);
    q = fma(q, r, 0.0416662822690034809f);
    q = fma(q, r, 0.166665429782796852f);
    q = fma(q, r, 0.500000006187774184f);
    return fma(r * r, q, r);
}

// 2^k for k in [-126, 127].
real real_power_of_two(int k) { return as_float((k + 127) << 23); }

// e^x: infinite above 88.72, subnormal below -87.33 (0 on devices that flush), NaN for NaN.
real real_exp(real x) {
    x = x < REAL_TINY_X ? REAL_TINY_X : x;
    x = x > REAL_BIG_X ? REAL_BIG_X : x;
    int k;
    real p = real_exp_parts(x, &k);
    int half_k = k >> 1;  // 2^k itself may overflow or underflow where the result does not
    return (1 + p) * real_power_of_two(half_k) * real_power_of_two(k - half_k);
}

// e^x - 1 without cancellation near 0.
real real_expm1(real x) {
    x = x < -20.0f ? -20.0f : x;
    x = x > REAL_BIG_X ? REAL_BIG_X : x;
    int k;
    real p = real_exp_parts(x, &k);
    real half_scale = real_power_of_two(k - 1);  // k may be 128
    return 2 * fma(p, half_scale, half_scale - 0.5f);
}

// log(1 + f) + e ln 2 for f in [-1/3, 1/3]. Fit: 5e-9.
real real_log_parts(real f, int e) {
    real q = -0.131914714633290215f;
    q = fma(q, f, 0.139624495848765523f);
    q = fma(q, f, -0.121151698312552204f);
    q = fma(q, f, 0.14010920118608173f);
    q = fma(q, f, -0.166854625428916653f);
    q = fma(q, f, 0.200100438932449374f);
    q = fma(q, f, -0.249996888312309858f);
    q = fma(q, f, 0.333332238449920077f);
    real r = fma(f * f, fma(q, f, -0.5f), f);
    real exponent = (real)e;
    return fma(exponent, REAL_LN2, fma(exponent, REAL_LN2_REST, r));
}

// How far the exponent of x lies from that of [2/3, 4/3), in place: a multiple of 2^23.
int real_exponent_bits(real x) { return (as_int(x) - as_int(0.66666667f)) & ~0x7fffff; }

// ln x: -infinity at 0, NaN below. Subnormal x are exact where the device keeps them.
real real_log(real x) {
    int subnormal = x < 1.17549435e-38f;
    real scaled = subnormal ? x * 8388608.0f : x;
    int bits = real_exponent_bits(scaled);
    real f = as_float(as_int(scaled) - bits) - 1;
    real y = real_log_parts(f, (bits >> 23) - (subnormal ? 23 : 0));
    y = x < INFINITY ? y : x;  // infinity and NaN give themselves
    y = x == 0 ? -INFINITY : y;
    return x < 0 ? NAN : y;
}

// ln(1 + x) without cancellation near 0. The exponent of 1 + x scales 1 and x one by one:
// f = x 2^-e + (2^-e - 1), where the bracket is exact (after N. Juffa's log1pf).
real real_log1p(real x) {
    int bits = real_exponent_bits(1 + x);
    real four_over_scale = as_float(as_int(4.0f) - bits);  // 4 2^-e is normal where 2^-e is not
    real f = as_float(as_int(x) - bits) + fma(0.25f, four_over_scale, -1.0f);
    f = bits == 0 ? x : f;
    real y = real_log_parts(f, bits >> 23);
    y = x < INFINITY ? y : x;
    y = x == -1 ? -INFINITY : y;
    return x < -1 ? NAN : y;
}

// ln t for t = 1 - x in (0, 1], given both: exact where either is small, for one polynomial.
real real_log_split(real t, real x) {
    int bits = real_exponent_bits(t);
    real four_over_scale = as_float(as_int(4.0f) - bits);
    real near_one = fma(-0.25f * four_over_scale, x, fma(0.25f, four_over_scale, -1.0f));
    return real_log_parts(x < 0.5f ? near_one : as_float(as_int(t) - bits) - 1, bits >> 23);
}

// (cos, sin) of an angle of at most an eighth of a turn. Fits: 4e-9.
real2 real_circle_octant(real turns) {
    real t = turns * turns;
    real s = fma(fma(-75.4534227651065542f, t, 81.5939375678151833f), t, -41.3416731648103602f);
    real sine = fma(turns, 6.28318530717958648f, turns * fma(s, t, REAL_TWO_PI_REST));
    real c = fma(fma(59.245982121781977f, t, -85.4437422659718194f), t, 64.9393264764056253f);
    c = fma(c, t, -19.7392086936678751f);
    return (real2)(fma(c, t, 1.0f), sine);
}

// The point (cos, sin) of the unit circle at an angle in turns, |turns| < 2^20.
real2 real_circle(real turns) {
    real rounded = fma(turns, 4.0f, REAL_ROUNDER);
    int quadrant = as_int(rounded) - as_int(REAL_ROUNDER);
    real2 p = real_circle_octant(fma(rounded - REAL_ROUNDER, -0.25f, turns));
    int odd = quadrant & 1;  // selects and sign bits: a branch would be mispredicted half the time
    int cosine = as_int(odd ? p.y : p.x) ^ (((quadrant + 1) & 2) << 30);
    int sine = as_int(odd ? p.x : p.y) ^ ((quadrant & 2) << 30);
    return (real2)(as_float(cosine), as_float(sine));
}

// Angle in turns of the point (x, y), x and y at least 0 and not both 0: in [0, 1/4]. Fit: 1.5e-8.
real real_angle(real y, real x) {
    int steep = y > x;
    real z = steep ? x / y : y / x;
    real t = z * z;
    real q = 0.000473428221685363396f;
    q = fma(q, t, -0.0026390067163363471f);
    q = fma(q, t, 0.00693180709108839042f);
    q = fma(q, t, -0.0120649013244416883f);
    q = fma(q, t, 0.0169960765721832327f);
    q = fma(q, t, -0.022622619584605156f);
    q = fma(q, t, 0.0318216579413132923f);
    q = fma(q, t, -0.0530513829182644082f);
    real angle = z * fma(q, t, 0.15915494309189533577f);
    return steep ? 0.25f - angle : angle;
}

#endif

// base^n for base and n at least 0; 0^0 = 1. Relative error at most 6e-8 (2 + 3 |n ln base|).
real real_power(real base, real n) { return n == 0 ? 1 : real_exp(n * real_log(base)); }

#endif
