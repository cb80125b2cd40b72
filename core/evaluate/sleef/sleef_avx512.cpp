// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/sleef/sleef_functions.h"

#if defined(__clang__) && defined(__x86_64__)
#include <immintrin.h>

#define ISOSCOPE_CALL_1(function)                                                    \
    extern "C" __m512d Sleef_##function##d8_u10avx512f(__m512d);                     \
    void function##InMemoryAvx512(const double* a, double* result) {                 \
        _mm512_store_pd(result, Sleef_##function##d8_u10avx512f(_mm512_load_pd(a))); \
    }
#define ISOSCOPE_CALL_2(function)                                                                       \
    extern "C" __m512d Sleef_##function##d8_u10avx512f(__m512d, __m512d);                               \
    void function##InMemoryAvx512(const double* a, const double* b, double* result) {                   \
        _mm512_store_pd(result, Sleef_##function##d8_u10avx512f(_mm512_load_pd(a), _mm512_load_pd(b))); \
    }

namespace isoscope::sleef {
ISOSCOPE_SLEEF_FUNCTIONS(ISOSCOPE_CALL_1, ISOSCOPE_CALL_2)
}
#endif
