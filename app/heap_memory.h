// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

#if defined(__GLIBC__)
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace isoscope {

/// Lets the program keep some of the memory that it has freed. Drawing frees lists of a batch and asks for
/// them again at the next one; glibc would hand more than 128 kB back to the system each time, and every
/// page would have to be cleared anew.
inline void keepFreedMemory([[maybe_unused]] std::size_t most) {
#if defined(__GLIBC__)
    mallopt(M_TRIM_THRESHOLD, static_cast<int>(most));
    // What is larger comes from the system directly; to set the one stops glibc from adapting the other.
    mallopt(M_MMAP_THRESHOLD, 4 << 20);
#endif
}

/// Asks for the next `room` bytes of the heap in large pages, where the system has some: to touch a page for
/// the first time, and to find it again when there are many, is a good part of a simple picture's time. What
/// is not used takes no memory.
inline void takeLargePages([[maybe_unused]] std::size_t room) {
#if defined(__GLIBC__) && defined(MADV_HUGEPAGE)
    constexpr std::uintptr_t page = 2 << 20;
    mallopt(M_TOP_PAD, static_cast<int>(room));
    const auto begin = reinterpret_cast<std::uintptr_t>(sbrk(0));
    // Makes the heap grow; the compiler must not see that it is not used.
    void* volatile some = std::malloc(page);
    std::free(some);
    const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0));
    const std::uintptr_t first = (begin + page - 1) / page * page;
    // In vain is no matter.
    if (first < end) madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
#endif
}

/// Where the system refuses memory, lets the heap grow by no more than what is asked for, and has it asked
/// once more: room for large pages is no reason to fail.
inline void growByNeedWhereShort() {
#if defined(__GLIBC__)
    std::set_new_handler([] {
        thread_local bool before = false;
        if (before) throw std::bad_alloc();
        before = true;
        mallopt(M_TOP_PAD, 0);
    });
#endif
}

/// Makes the heap ready for drawing. To be called before there are threads.
inline void prepareHeap() {
    constexpr std::size_t room = 16 << 20;
    keepFreedMemory(2 * room);
    takeLargePages(room);
    growByNeedWhereShort();
}

}  // namespace isoscope
