// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/lipschitz/lipschitz_kernel.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/roots/lipschitz/lipschitz_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// At most eight lanes, so that a mask fits into a byte.
using Doubles = hn::CappedTag<double, 8>;
using Vector = hn::Vec<Doubles>;
using Mask = hn::Mask<Doubles>;

HWY_INLINE std::uint64_t bitsOf(Mask mask) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(Doubles(), mask, bits);
    return bits[0];
}

/// What the rules say about one half of the interval.
struct Half {
    Mask wanted;   ///< may hold a root, and can be halved
    Mask special;  ///< its right end is a root, or its slope is to be noted
    Vector middle;
};

HWY_INLINE Half examine(Vector start, Vector startValue, Vector end, Vector endValue, Vector reach,
                        Vector speed, const HalvingLimits& limits) {
    const Doubles d;
    const Vector zero = hn::Zero(d);
    const Vector width = hn::Sub(end, start);
    const Vector middle = hn::Mul(hn::Add(start, end), hn::Set(d, 0.5));
    const Mask divisible = hn::And(hn::Ge(width, hn::Set(d, limits.accuracy)),
                                   hn::And(hn::Lt(start, middle), hn::Lt(middle, end)));
    const Mask possible = hn::Lt(hn::Sub(hn::Add(startValue, endValue), reach), zero);
    const Mask root = hn::AndNot(divisible, hn::Lt(endValue, zero));
    const Vector change = hn::Abs(hn::Sub(endValue, startValue));
    const Mask steep = hn::Gt(change, hn::Mul(hn::Set(d, limits.noteworthy), hn::Mul(width, speed)));
    return {hn::And(divisible, possible), hn::Or(root, steep), middle};
}

HalvingStep halveLanes(HalvingState& state, const double* values, std::size_t count,
                       const HalvingLimits& limits) {
    const Doubles d;
    HalvingStep step;
    for (std::size_t i = 0; i < count; i += hn::MaxLanes(d)) {
        const Vector start = hn::Load(d, &state.start[i]);
        const Vector startValue = hn::Load(d, &state.startValue[i]);
        const Vector end = hn::Load(d, &state.end[i]);
        const Vector endValue = hn::Load(d, &state.endValue[i]);
        const Vector speed = hn::Load(d, &state.speed[i]);
        const Vector lowest = hn::Load(d, &state.lowest[i]);
        const Vector before = hn::Load(d, &state.reach[i]);
        const Vector reach = hn::Mul(before, hn::Set(d, 0.5));
        const Vector middle = hn::Load(d, &state.wanted[i]);
        const Vector value = hn::Mul(hn::Load(d, &state.sign[i]),
                                     hn::Sub(hn::LoadU(d, values + i), hn::Set(d, limits.threshold)));

        const Half left = examine(start, startValue, middle, value, reach, speed, limits);
        const Half right = examine(middle, value, end, endValue, reach, speed, limits);
        const Mask special = hn::Or(left.special, right.special);
        const Mask keepStart = hn::Or(left.wanted, special);
        const Mask keepEnd = hn::Or(hn::Not(left.wanted), special);

        hn::Store(hn::IfThenElse(hn::Lt(value, lowest), value, lowest), d, &state.lowest[i]);
        hn::Store(end, d, &state.asideEnd[i]);
        hn::Store(endValue, d, &state.asideEndValue[i]);
        hn::Store(hn::IfThenElse(keepStart, start, middle), d, &state.start[i]);
        hn::Store(hn::IfThenElse(keepStart, startValue, value), d, &state.startValue[i]);
        hn::Store(hn::IfThenElse(keepEnd, end, middle), d, &state.end[i]);
        hn::Store(hn::IfThenElse(keepEnd, endValue, value), d, &state.endValue[i]);
        hn::Store(hn::IfThenElse(special, before, reach), d, &state.reach[i]);
        hn::Store(hn::IfThenElse(special, middle, hn::IfThenElse(left.wanted, left.middle, right.middle)), d,
                  &state.wanted[i]);

        step.special |= bitsOf(special) << i;
        step.bothHalves |= bitsOf(hn::AndNot(special, hn::And(left.wanted, right.wanted))) << i;
        step.neitherHalf |= bitsOf(hn::Not(hn::Or(special, hn::Or(left.wanted, right.wanted)))) << i;
    }
    return step;
}

void placeLanes(HalvingState& state, std::size_t count) {
    const Doubles d;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t i = 0; i < count; i += hn::MaxLanes(d)) {
            const Vector way =
                hn::Mul(hn::Load(d, &state.wanted[i]), hn::LoadU(d, &state.direction[axis][i]));
            hn::Store(hn::Add(hn::LoadU(d, &state.origin[axis][i]), way), d, &state.point[axis][i]);
        }
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(halveLanes);
HWY_EXPORT(placeLanes);

HalvingStep halve(HalvingState& state, const double* values, std::size_t count, const HalvingLimits& limits) {
    return HWY_DYNAMIC_DISPATCH(halveLanes)(state, values, count, limits);
}

void placePoints(HalvingState& state, std::size_t count) { HWY_DYNAMIC_DISPATCH(placeLanes)(state, count); }

}  // namespace isoscope
#endif
