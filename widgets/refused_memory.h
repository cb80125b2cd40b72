// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <new>

namespace isoscope {

/// Does the work of a background thread that may be refused memory: it ends there, as if it had been stopped,
/// the rest of the program goes on, and standard error is told. Returns whether the work was done.
template <class Work>
bool doneUnlessMemoryIsRefused(Work work) {
    try {
        work();
        return true;
    } catch (const std::bad_alloc&) {
        std::fputs("isoscope: there is not enough memory for what a panel is to show\n", stderr);
        return false;
    }
}

}  // namespace isoscope
