// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/certain_starts.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/roots/certified/certain_starts.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// As CertainStarts::open().
bool areOpen(const LineColumns& lines, const double* starts, const double* signs, std::size_t first,
             std::size_t count) {
    const hn::ScalableTag<double> d;
    auto some = hn::Lt(hn::Zero(d), hn::Zero(d));
    for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
        const std::size_t i = first + k;
        const auto far = hn::LoadU(d, lines.far + i);
        const auto passes = hn::And(hn::FirstN(d, count - k), hn::Lt(hn::LoadU(d, lines.near + i), far));
        const auto known = hn::Ne(hn::LoadU(d, signs + i), hn::Zero(d));
        const auto through = hn::And(hn::And(passes, known), hn::Ge(hn::LoadU(d, starts + i), far));
        if (!hn::AllFalse(d, through)) return false;
        some = hn::Or(some, passes);
    }
    return !hn::AllFalse(d, some);
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(areOpen);

bool CertainStarts::open(const LineColumns& lines, std::size_t first, std::size_t count) const {
    return HWY_DYNAMIC_DISPATCH(areOpen)(lines, start_.data(), sign_.data(), first, count);
}

}  // namespace isoscope
#endif
