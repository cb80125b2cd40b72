// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Replaces the operators new and delete of the program: for one source of a test.

#include <cstddef>
#include <cstdlib>
#include <new>

namespace isoscope::test {

/// Allocations that are still granted; -1 grants all. Of this thread alone, for TBB has threads of its own.
inline thread_local long granted = -1;
/// How many were asked for.
inline thread_local long asked = 0;

/// Whether this allocation is the one.
inline bool refused() {
    ++asked;
    if (granted < 0) return false;
    if (granted > 0) {
        --granted;
        return false;
    }
    granted = -1;  // once: while the stack is unwound memory becomes free again
    return true;
}

/// Throws std::bad_alloc where it is refused.
inline void* memoryFor(std::size_t size, std::size_t alignment = alignof(std::max_align_t)) {
    if (refused()) throw std::bad_alloc();
    void* memory = alignment <= alignof(std::max_align_t)
                       ? std::malloc(size)
                       : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
    if (!memory) throw std::bad_alloc();
    return memory;
}

/// The result of `read`, whose allocation `at` is refused.
template <class Read>
auto refusing(long at, bool& happened, const Read& read) {
    granted = at;
    auto result = read();
    happened = at >= 0 && granted < 0;
    granted = -1;
    return result;
}

}  // namespace isoscope::test

// These may not be inline, and stand in one source of a program.
// NOLINTBEGIN(misc-definitions-in-headers)
void* operator new(std::size_t size) { return isoscope::test::memoryFor(size); }
void* operator new[](std::size_t size) { return isoscope::test::memoryFor(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
    return isoscope::test::memoryFor(size, static_cast<std::size_t>(alignment));
}
// What sorts stably asks for its room in this way, and does without.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return isoscope::test::refused() ? nullptr : std::malloc(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
    return isoscope::test::refused() ? nullptr : std::malloc(size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
// NOLINTEND(misc-definitions-in-headers)
