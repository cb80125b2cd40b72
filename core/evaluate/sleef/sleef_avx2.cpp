// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/sleef/sleef_functions.h"

#if defined(__clang__) && defined(__x86_64__)
#include <immintrin.h>

#define ISOSCOPE_CALL_1(function)                                                 \
    extern "C" __m256d Sleef_##function##d4_u10avx2(__m256d);                     \
    void function##InMemoryAvx2(const double* a, double* result) {                \
        _mm256_store_pd(result, Sleef_##function##d4_u10avx2(_mm256_load_pd(a))); \
    }
#define ISOSCOPE_CALL_2(function)                                                                    \
    extern "C" __m256d Sleef_##function##d4_u10avx2(__m256d, __m256d);                               \
    void function##InMemoryAvx2(const double* a, const double* b, double* result) {                  \
        _mm256_store_pd(result, Sleef_##function##d4_u10avx2(_mm256_load_pd(a), _mm256_load_pd(b))); \
    }

namespace isoscope::sleef {
ISOSCOPE_SLEEF_FUNCTIONS(ISOSCOPE_CALL_1, ISOSCOPE_CALL_2)
}
#endif
