// SPDX-License-Identifier: GPL-3.0-or-later
// ISOSCOPE_SLEEF_DEFINE_1 and _2, for ISOSCOPE_SLEEF_FUNCTIONS: definitions of the functions in memory of one
// instruction set. A source that is compiled for this set as a whole says before RawVector, SLEEF's vector;
// ISOSCOPE_SLEEF_NAME(function), SLEEF's name of a function, and ISOSCOPE_SLEEF_IN_MEMORY(function), ours.
#pragma once

#include "core/evaluate/sleef/sleef_functions.h"

#define ISOSCOPE_SLEEF_DEFINE_1(function)                                          \
    extern "C" RawVector ISOSCOPE_SLEEF_NAME(function)(RawVector);                 \
    void ISOSCOPE_SLEEF_IN_MEMORY(function)(const double* a, double* result) {     \
        *reinterpret_cast<RawVector*>(result) =                                    \
            ISOSCOPE_SLEEF_NAME(function)(*reinterpret_cast<const RawVector*>(a)); \
    }
#define ISOSCOPE_SLEEF_DEFINE_2(function)                                                       \
    extern "C" RawVector ISOSCOPE_SLEEF_NAME(function)(RawVector, RawVector);                   \
    void ISOSCOPE_SLEEF_IN_MEMORY(function)(const double* a, const double* b, double* result) { \
        *reinterpret_cast<RawVector*>(result) = ISOSCOPE_SLEEF_NAME(function)(                  \
            *reinterpret_cast<const RawVector*>(a), *reinterpret_cast<const RawVector*>(b));    \
    }
