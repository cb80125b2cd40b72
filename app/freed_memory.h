// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace isoscope {

/// Lets the program keep some of the memory that it has freed. Drawing frees lists of a batch and asks for
/// them again at the next one; glibc would hand more than 128 kB back to the system each time, and every
/// page would have to be cleared anew. To be called before there are threads.
inline void keepFreedMemory() {
#if defined(__GLIBC__)
    mallopt(M_TRIM_THRESHOLD, 16 << 20);
    // What is larger comes from the system directly; to set the one stops glibc from adapting the other.
    mallopt(M_MMAP_THRESHOLD, 4 << 20);
#endif
}

}  // namespace isoscope
