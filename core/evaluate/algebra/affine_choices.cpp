// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/algebra/affine_choices.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/evaluate/algebra/affine_choices.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <limits>

#include "core/evaluate/tape/tape_workspace.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, batchLanes>;
using Vector = hn::Vec<Doubles>;
using Mask = hn::Mask<Doubles>;

struct Form {
    Vector a, b, e;
};

HWY_INLINE Vector constant(double value) { return hn::Set(Doubles(), value); }

HWY_INLINE Form loadForm(const AffineOperand& operand, std::size_t i) {
    if (operand.lanes == nullptr)
        return {constant(operand.uniform.a), constant(operand.uniform.b), constant(operand.uniform.e)};
    const auto load = [&](std::size_t k)
                          HWY_ATTR { return hn::LoadU(Doubles(), operand.lanes + k * batchLanes + i); };
    return {load(0), load(1), load(2)};
}

HWY_INLINE Form formOf(const SignLevel& level) {
    return {constant(level.value), hn::Zero(Doubles()), constant(level.reach)};
}

HWY_INLINE Mask isKnown(const Form& p) {
    return hn::Lt(hn::Abs(p.e), constant(std::numeric_limits<double>::infinity()));
}

struct Order {
    Mask below, above;
};

/// Whether p < q, and whether p > q, all along; false for what is not known.
HWY_INLINE Order certainOrder(const Form& p, const Form& q) {
    const Mask known = hn::And(isKnown(p), isKnown(q));
    const Vector errors = hn::Add(p.e, q.e);
    const Vector size =
        hn::Add(hn::Add(hn::Add(hn::Abs(p.a), hn::Abs(q.a)), hn::Add(hn::Abs(p.b), hn::Abs(q.b))), errors);
    // Six roundings of numbers within `size`.
    const Vector reach = hn::Add(hn::Add(hn::Abs(hn::Sub(p.b, q.b)), errors), hn::Mul(constant(1e-15), size));
    const Vector difference = hn::Sub(p.a, q.a);
    return {hn::And(known, hn::Lt(hn::Add(difference, reach), hn::Zero(Doubles()))),
            hn::And(known, hn::Gt(hn::Sub(difference, reach), hn::Zero(Doubles())))};
}

HWY_INLINE std::uint64_t bitsOf(Mask mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(Doubles(), mask, bytes);
    constexpr unsigned lanes = hn::MaxLanes(Doubles()) < 8 ? hn::MaxLanes(Doubles()) : 8;
    return bytes[0] & ((1u << lanes) - 1);
}

void decideAll(const AffineOperand& first, const AffineOperand& second, bool takesLower,
               const SignLevel* level, std::size_t count, LaneChoices& choices) {
    static_assert(hn::MaxLanes(Doubles()) <= 8);
    for (std::size_t i = 0; i < count; i += hn::Lanes(Doubles())) {
        const Form p = loadForm(first, i), q = loadForm(second, i);
        const Order order = certainOrder(p, q);
        Mask takesFirst = takesLower ? order.below : order.above;
        Mask takesSecond = takesLower ? order.above : order.below;
        if (level != nullptr) {
            // What is above the level is above it, whichever operand of min is left to say so.
            const Form number = formOf(*level);
            const Order ofFirst = certainOrder(p, number), ofSecond = certainOrder(q, number);
            const Mask known = hn::And(isKnown(p), isKnown(q));
            const Mask leavesFirst = hn::And(known, takesLower ? ofFirst.above : ofFirst.below);
            const Mask leavesSecond = hn::And(known, takesLower ? ofSecond.above : ofSecond.below);
            takesSecond = hn::Or(takesSecond, hn::AndNot(takesFirst, leavesFirst));
            takesFirst = hn::Or(takesFirst, hn::AndNot(takesSecond, leavesSecond));
        }
        choices.first |= bitsOf(takesFirst) << i;
        choices.second |= bitsOf(takesSecond) << i;
    }
}

void compareAll(const AffineOperand& form, const SignLevel& level, std::size_t count, LanesBeyond& beyond) {
    const Form other = formOf(level);
    for (std::size_t i = 0; i < count; i += hn::Lanes(Doubles())) {
        const Order order = certainOrder(loadForm(form, i), other);
        beyond.above |= bitsOf(order.above) << i;
        beyond.below |= bitsOf(order.below) << i;
    }
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(decideAll);
HWY_EXPORT(compareAll);

namespace {

/// A bit for each of the first `count` lanes.
std::uint64_t firstLanes(std::size_t count) {
    return count < batchLanes ? (std::uint64_t(1) << count) - 1 : ~std::uint64_t(0);
}

}  // namespace

LaneChoices decideAffineChoices(const AffineOperand& first, const AffineOperand& second, bool takesLower,
                                const SignLevel* level, std::size_t count) {
    LaneChoices choices;
    HWY_DYNAMIC_DISPATCH(decideAll)(first, second, takesLower, level, count, choices);
    choices.first &= firstLanes(count), choices.second &= firstLanes(count);
    return choices;
}

LanesBeyond lanesBeyond(const AffineOperand& form, const SignLevel& level, std::size_t count) {
    LanesBeyond beyond;
    HWY_DYNAMIC_DISPATCH(compareAll)(form, level, count, beyond);
    beyond.above &= firstLanes(count), beyond.below &= firstLanes(count);
    return beyond;
}

}  // namespace isoscope
#endif
