// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/first_roots.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/roots/first_roots.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;
using Bytes = hn::Rebind<std::uint8_t, Doubles>;

static_assert(sizeof(Verdict) == 1);

void noteAll(const double* places, std::size_t count, Verdict found, Verdict* verdicts) {
    const Doubles d;
    const hn::Rebind<std::int32_t, Doubles> integers;
    const Bytes bytes;
    const auto none = hn::Set(d, FirstRoots::none);
    const auto one = hn::Set(d, static_cast<double>(found));
    auto* const out = reinterpret_cast<std::uint8_t*>(verdicts);
    std::size_t i = 0;
    for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
        const auto at = hn::Lt(hn::LoadU(d, places + i), none);
        if (hn::AllFalse(d, at)) continue;
        const auto before = hn::PromoteTo(d, hn::PromoteTo(integers, hn::LoadU(bytes, out + i)));
        const auto after = hn::IfThenElse(at, one, before);
        hn::StoreU(hn::DemoteTo(bytes, hn::DemoteTo(integers, after)), bytes, out + i);
    }
    for (; i < count; ++i)
        if (places[i] < FirstRoots::none) verdicts[i] = found;
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(noteAll);

void FirstRoots::noteCrossings(Verdict found, std::span<Verdict> verdicts) const {
    HWY_DYNAMIC_DISPATCH(noteAll)(crossings[t], verdicts.size(), found, verdicts.data());
}

}  // namespace isoscope
#endif
