// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/sleef/sleef_in_memory.h"

#if defined(__clang__) && defined(__x86_64__)
#define ISOSCOPE_SLEEF_NAME(function) Sleef_##function##d4_u10avx2
#define ISOSCOPE_SLEEF_IN_MEMORY(function) function##InMemoryAvx2

namespace isoscope::sleef {

using RawVector = double __attribute__((vector_size(32), may_alias));
ISOSCOPE_SLEEF_FUNCTIONS(ISOSCOPE_SLEEF_DEFINE_1, ISOSCOPE_SLEEF_DEFINE_2)

}  // namespace isoscope::sleef
#endif
