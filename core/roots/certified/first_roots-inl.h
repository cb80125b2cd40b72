// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. Writes roots of many lines into FirstRoots.
#if defined(ISOSCOPE_ROOTS_FIRST_ROOTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_ROOTS_FIRST_ROOTS_INL
#undef ISOSCOPE_ROOTS_FIRST_ROOTS_INL
#else
#define ISOSCOPE_ROOTS_FIRST_ROOTS_INL
#endif

#include <hwy/highway.h>

#include "core/evaluate/algebra/compress-inl.h"
#include "core/evaluate/tape/tape_workspace.h"
#include "core/roots/first_roots.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using RootTag = hn::CappedTag<double, batchLanes>;

/// Each lane of `mask` to its line.
HWY_INLINE void putRoots(hn::Mask<RootTag> mask, hn::Vec<RootTag> lines, hn::Vec<RootTag> t,
                         const hn::Vec<RootTag> (&normal)[3], FirstRoots& roots) {
    const RootTag tag;
    HWY_ALIGN double lanes[1 + FirstRoots::columnCount][batchLanes];
    appendLanes(tag, lines, mask, lanes[0]);
    appendLanes(tag, t, mask, lanes[1 + FirstRoots::t]);
    for (std::size_t c = 0; c < 3; ++c) appendLanes(tag, normal[c], mask, lanes[1 + FirstRoots::normalX + c]);
    const std::size_t count = hn::CountTrue(tag, mask);
    for (std::size_t c = 0; c < FirstRoots::columnCount; ++c) {
        double* const column = roots.crossings[c];
        for (std::size_t k = 0; k < count; ++k)
            column[static_cast<std::size_t>(lanes[0][k])] = lanes[1 + c][k];
    }
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
