// SPDX-License-Identifier: Apache-2.0
// The number type of all device arithmetic. The shipped kernels build with float; the same source
// built with LOBE_DOUBLE is the oracle that shows what float loses.
#ifndef LOBE_CORE_REAL_H
#define LOBE_CORE_REAL_H

#pragma OPENCL FP_CONTRACT OFF

#ifndef LOBE_DOUBLE
#define LOBE_DOUBLE 0
#endif

#if LOBE_DOUBLE
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
typedef double real;
typedef double2 real2;
typedef double3 real3;
typedef double4 real4;
typedef double8 real8;
typedef long8 mask8;  // what comparing two real8 gives: all bits of a true lane set
#define R(literal) literal
#define REAL_EPSILON 1.1102230246251565e-16  // 2^-53, half an ulp of one
#define to_real8 convert_double8
#else
typedef float real;
typedef float2 real2;
typedef float3 real3;
typedef float4 real4;
typedef float8 real8;
typedef int8 mask8;
#define R(literal) literal##f
#define REAL_EPSILON 5.9604644775390625e-8f  // 2^-24
#define to_real8 convert_float8
#endif

#define REAL_PI R(3.14159265358979323846)
#define REAL_TWO_PI R(6.28318530717958647693)
#define REAL_INV_PI R(0.31830988618379067154)
#define REAL_INV_TWO_PI R(0.15915494309189533577)
#define REAL_HUGE R(1e30)

#endif
