// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/march_lanes.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/roots/certified/march_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cstdint>

#include "core/roots/certified/march_step-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

using Vector = hn::Vec<MarchTag>;
using Codes = hn::Rebind<std::int32_t, MarchTag>;
static_assert(sizeof(MarchEvent) == sizeof(std::int32_t));

HWY_INLINE Vector constant(double value) { return hn::Set(MarchTag(), value); }

HWY_INLINE MarchStep<false> load(const RayPieces& pieces, const MarchLanes& lanes, std::size_t i) {
    const auto at = [i](const MarchLanes::Lanes& column)
                        HWY_ATTR { return hn::LoadU(MarchTag(), &column[i]); };
    MarchStep<false> step;
    step.t = at(pieces.start), step.h = at(pieces.length), step.far = at(lanes.far);
    step.resolution = at(lanes.resolution), step.tolerance = at(lanes.tolerance);
    step.sign = at(lanes.sign), step.signPlace = at(lanes.signPlace);
    step.watched = at(lanes.watched), step.unresolvedError = at(lanes.unresolvedError);
    return step;
}

/// Writes the lanes back; those with an event that keeps its piece only count the evaluation.
HWY_INLINE bool finish(MarchStep<false>& step, RayPieces& pieces, MarchLanes& lanes, std::size_t i,
                       MarchEvent* events) {
    const auto store = [i](Vector value, MarchLanes::Lanes& column)
                           HWY_ATTR { hn::StoreU(value, MarchTag(), &column[i]); };
    const Vector evaluations = hn::Add(hn::LoadU(MarchTag(), &lanes.evaluations[i]), constant(1));
    store(evaluations, lanes.evaluations);
    step.raiseEnd();
    step.raise(MarchEvent::exhausted, hn::Ge(evaluations, hn::LoadU(MarchTag(), &lanes.budget[i])));
    store(step.t, pieces.start);
    // What is known of a piece holds as far as it goes, and pieces by cases may be shorter than the
    // resolution.
    const auto is = [&](MarchEvent event)
                        HWY_ATTR { return hn::Eq(step.events, constant(static_cast<double>(event))); };
    const auto kept = hn::Or(is(MarchEvent::crossing), is(MarchEvent::undefined));
    store(hn::IfThenElse(kept, step.h, step.nextLength()), pieces.length);
    store(step.sign, lanes.sign);
    store(step.signPlace, lanes.signPlace);
    store(step.unresolvedError, lanes.unresolvedError);
    store(step.newSign, lanes.newSign);
    store(step.slope, lanes.slope);
    store(step.error, lanes.error);
    store(step.low, lanes.low);
    store(step.high, lanes.high);
    const Codes codes;
    hn::StoreU(hn::DemoteTo(codes, step.events), codes, reinterpret_cast<std::int32_t*>(events + i));
    return !hn::AllTrue(MarchTag(), step.live);
}

bool marchAll(RayPieces& pieces, MarchLanes& lanes, const AffineLanes& forms, const SignRule& rule,
              std::size_t count, MarchEvent* events) {
    const Vector threshold = constant(rule.threshold);
    const Vector polarity = constant(rule.positivePolarity ? -1 : 1);
    bool any = false;
    for (std::size_t i = 0; i < count; i += hn::Lanes(MarchTag())) {
        const Vector a = hn::LoadU(MarchTag(), forms.center + i);
        const Vector b = hn::LoadU(MarchTag(), forms.slope + i);
        MarchStep<false> step = load(pieces, lanes, i);
        step.take(hn::Mul(hn::Sub(a, threshold), polarity), hn::Mul(b, polarity),
                  thresholdError(a, hn::LoadU(MarchTag(), forms.error + i)));
        any |= finish(step, pieces, lanes, i, events);
    }
    return any;
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(marchAll);

bool march(RayPieces& pieces, MarchLanes& lanes, const AffineLanes& forms, const SignRule& rule,
           std::size_t count, MarchEvent* events) {
    return HWY_DYNAMIC_DISPATCH(marchAll)(pieces, lanes, forms, rule, count, events);
}

}  // namespace isoscope
#endif
