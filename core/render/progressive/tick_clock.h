// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

#if defined(__x86_64__) && defined(__GNUC__)
#include <x86intrin.h>
#endif

namespace isoscope {

/// Time that passes, in unspecified units: to compare what parts of a work take. The processor's own
/// counter where there is one: the system's clock takes several times as long to read, and a simple picture
/// asks for it a thousand times.
inline std::uint64_t ticks() {
#if defined(__x86_64__) && defined(__GNUC__)
    return __rdtsc();
#elif defined(__aarch64__) && defined(__GNUC__)
    std::uint64_t now;
    asm volatile("mrs %0, cntvct_el0" : "=r"(now));
    return now;
#else
    return static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count());
#endif
}

}  // namespace isoscope
