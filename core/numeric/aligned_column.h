// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace isoscope {

/// Memory that begins with a line of the processor's cache: vector instructions that read or write a whole
/// line would touch two of them otherwise.
template <class Number>
struct CacheLineAllocator {
    using value_type = Number;
    static constexpr std::align_val_t alignment{64};

    CacheLineAllocator() = default;
    template <class Other>
    CacheLineAllocator(const CacheLineAllocator<Other>&) {}

    /// What a standard allocator has to have: memory for `count` numbers, and back. Throws std::bad_alloc.
    Number* allocate(std::size_t count) {
        return static_cast<Number*>(::operator new(count * sizeof(Number), alignment));
    }
    void deallocate(Number* memory, std::size_t) { ::operator delete(memory, alignment); }
    template <class Other>
    bool operator==(const CacheLineAllocator<Other>&) const {
        return true;
    }
};

/// Numbers of one kind that belong to many things, for vector instructions.
using AlignedColumn = std::vector<double, CacheLineAllocator<double>>;

}  // namespace isoscope
