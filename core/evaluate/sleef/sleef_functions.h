// SPDX-License-Identifier: GPL-3.0-or-later
// The functions that we call of SLEEF, and for clang the same with numbers in memory. clang hands vectors
// wider than its baseline's over in memory, whatever the set of the function that calls, but SLEEF takes them
// in registers: sources that are compiled for such a set as a whole (sleef_avx2.cpp, sleef_avx512.cpp) call
// it.
#pragma once

/// one(name) and two(name) for each function of one and of two arguments.
#define ISOSCOPE_SLEEF_FUNCTIONS(one, two)                                                          \
    one(sin) one(cos) one(tan) one(asin) one(acos) one(atan) one(exp) one(log) one(log10) one(sinh) \
        one(cosh) one(tanh) one(asinh) one(acosh) one(atanh) two(pow) two(atan2)

#ifdef __clang__
/// Functions of the `a` (and `b`) in arrays of one vector, aligned as such: 4 numbers for AVX2, 8 for
/// AVX-512, within SLEEF's error of 1.0 ulp. `result` may be one of the arguments. Only for machines that
/// have the instruction set.
#define ISOSCOPE_SLEEF_DECLARE_1(function)                        \
    void function##InMemoryAvx2(const double* a, double* result); \
    void function##InMemoryAvx512(const double* a, double* result);
#define ISOSCOPE_SLEEF_DECLARE_2(function)                                         \
    void function##InMemoryAvx2(const double* a, const double* b, double* result); \
    void function##InMemoryAvx512(const double* a, const double* b, double* result);
namespace isoscope::sleef {
ISOSCOPE_SLEEF_FUNCTIONS(ISOSCOPE_SLEEF_DECLARE_1, ISOSCOPE_SLEEF_DECLARE_2)
}  // namespace isoscope::sleef
#undef ISOSCOPE_SLEEF_DECLARE_1
#undef ISOSCOPE_SLEEF_DECLARE_2
#endif
