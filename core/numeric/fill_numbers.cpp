// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/fill_numbers.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/numeric/fill_numbers.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

void fillAll(double* to, std::size_t count, double number) {
    const hn::ScalableTag<double> d;
    const auto some = hn::Set(d, number);
    std::size_t k = 0;
    for (; k + hn::Lanes(d) <= count; k += hn::Lanes(d)) hn::StoreU(some, d, to + k);
    for (; k < count; ++k) to[k] = number;
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(fillAll);

void fillNumbers(double* to, std::size_t count, double number) {
    HWY_DYNAMIC_DISPATCH(fillAll)(to, count, number);
}

}  // namespace isoscope
#endif
