// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. One step of the march along rays (docs/evaluation.md), a vector at a
// time.
#if defined(ISOSCOPE_ROOTS_MARCH_STEP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_ROOTS_MARCH_STEP_INL
#undef ISOSCOPE_ROOTS_MARCH_STEP_INL
#else
#define ISOSCOPE_ROOTS_MARCH_STEP_INL
#endif

#include <hwy/highway.h>

#include <limits>

#include "core/roots/certified/march_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using MarchTag = hn::CappedTag<double, batchLanes>;

/// The error of center - threshold, given that of the form.
HWY_INLINE hn::Vec<MarchTag> thresholdError(hn::Vec<MarchTag> center, hn::Vec<MarchTag> error) {
    constexpr double rounding = 2 * std::numeric_limits<double>::epsilon();
    return hn::Add(error, hn::Mul(hn::Abs(center), hn::Set(MarchTag(), rounding)));
}

/// The lanes of one vector while they take one step. `live` are those without an event so far. Hardly a
/// branch: what happens to one of several lanes cannot be foreseen. A `plain` step knows no lane that has
/// stepped over anything: `unresolvedError` is 0, and a sign that is known is so right up to t.
template <bool plain>
struct MarchStep {
    using Vector = hn::Vec<MarchTag>;
    using Mask = hn::Mask<MarchTag>;
    static constexpr double unit = std::numeric_limits<double>::epsilon();
    static HWY_INLINE Vector constant(double value) { return hn::Set(MarchTag(), value); }

    // As in RayPieces and MarchLanes; to be loaded before, and stored after.
    Vector t, h, far, resolution, tolerance, sign;
    Vector watched;
    Vector signPlace, unresolvedError;  ///< not of a plain step
    bool brackets = false;              ///< whether there may be MarchEvent::bracket; of a plain step
    // What the step has come to.
    Vector low, high, slope, error, newSign;
    Vector events;
    Mask live;

    HWY_INLINE MarchStep() : events(hn::Zero(MarchTag())), live(hn::Eq(events, events)) {}

    /// The form a + b s + [-e, e], negative inside; NaN and infinite errors allowed.
    HWY_INLINE void take(Vector a, Vector b, Vector e) {
        const Vector zero = hn::Zero(MarchTag());
        // Slopes whose inverse could overflow count as errors.
        const Mask flat = hn::Lt(hn::Abs(b), constant(1e-290));
        e = hn::IfThenElse(flat, hn::Add(e, hn::Abs(b)), e);
        b = hn::IfThenZeroElse(flat, b);
        const Vector infinite = constant(std::numeric_limits<double>::infinity());
        const Mask known = hn::Lt(hn::Abs(e), infinite);
        raise(MarchEvent::undefined, hn::Eq(e, hn::Neg(infinite)));
        const Vector atStart = hn::Sub(a, b);
        const Mask certain =
            hn::And(live, hn::And(known, hn::Gt(hn::Mul(hn::Abs(atStart), constant(1 - 4 * unit)), e)));
        const Vector found = hn::CopySign(constant(1), atStart);
        const Mask fresh = hn::Eq(sign, zero);
        const Mask differs = hn::Ne(found, sign);
        const Mask news = hn::And(certain, hn::And(differs, hn::Or(hn::Not(fresh), hn::Lt(found, watched))));
        raise(MarchEvent::newSign, news);
        const Mask marching = hn::And(certain, live);
        sign = hn::IfThenElse(marching, found, sign);
        if constexpr (!plain) {
            signPlace = hn::IfThenElse(marching, t, signPlace);
            unresolvedError = hn::IfThenZeroElse(marching, unresolvedError);
        }
        const Vector upward = hn::Mul(a, sign), relative = hn::Mul(b, sign);
        const Vector end = hn::Add(upward, relative);
        const Mask opposite = hn::Lt(hn::Add(end, e), zero);
        perSlope = hn::Div(constant(1), relative);
        const Vector last = hn::Mul(unitClamp(hn::Add(place(hn::Add(upward, e)), constant(4 * unit))), h);
        newSign = found;
        slope = relative;
        error = e;
        high = hn::Add(t, last);
        const Mask open = hn::AndNot(certain, live);
        if (!hn::AllFalse(MarchTag(), open)) {
            // The threshold itself, all along: shorter pieces would tell no more.
            raise(MarchEvent::unresolved,
                  hn::And(open, hn::Eq(hn::Add(hn::Abs(a), hn::Add(hn::Abs(b), e)), zero)));
            signOpen(hn::And(open, live), known, opposite, last, upward);
        }
        signKnown(hn::And(marching, live), opposite, last, upward, end);
    }

    HWY_INLINE void raise(MarchEvent event, Mask where) {
        events = hn::IfThenElse(hn::And(where, live), constant(static_cast<double>(event)), events);
        live = hn::AndNot(where, live);
    }
    HWY_INLINE void raiseEnd() { raise(MarchEvent::reachedEnd, hn::Ge(t, far)); }
    /// The length of the next piece.
    HWY_INLINE Vector nextLength() const { return hn::Min(hn::Max(h, resolution), hn::Sub(far, t)); }

  private:
    Vector perSlope;  ///< 1 / slope

    /// Where value + slope s is 0, as a part of the piece, not limited to it. Within the piece it is wrong by
    /// less than 2 units.
    HWY_INLINE Vector place(Vector value) const {
        return hn::Mul(hn::Sub(constant(1), hn::Mul(value, perSlope)), constant(0.5));
    }
    /// Between 0 and 1; 0 for what is not a number.
    static HWY_INLINE Vector unitClamp(Vector part) {
        const Vector zero = hn::Zero(MarchTag());
        return hn::Min(hn::IfThenElse(hn::Gt(part, zero), part, zero), constant(1));
    }

    /// The end is reached exactly, whatever the sum of the pieces is rounded to.
    HWY_INLINE void advance(Mask where, Vector length) {
        const Vector rest = hn::Sub(far, t);
        // The resolution of a bundle may be longer than its lines.
        const Vector slack =
            hn::Min(hn::Mul(resolution, constant(1.0 / 64)), hn::Mul(constant(0x1p-30), hn::Abs(far)));
        const Mask through = hn::Or(hn::Ge(length, rest), hn::Lt(hn::Sub(rest, length), slack));
        t = hn::IfThenElse(where, hn::IfThenElse(through, far, hn::Add(t, length)), t);
    }

    /// How long the next piece should be, in parts of this one, where the function is about `value` and
    /// goes on with the slope 2 `slope` a part: up to where the form would lose its sign if its error grows
    /// with the square of the length. Only speed depends on it; the factors were found by trial.
    HWY_INLINE Vector nextPart(Vector value) const {
        const Vector excess = hn::Mul(error, constant(1.5));
        const Vector root = hn::Sqrt(hn::MulAdd(slope, slope, hn::Mul(excess, value)));
        const Vector part = hn::Div(hn::Add(slope, root), excess);
        const Vector longest = constant(1.8);
        return hn::Max(hn::IfThenElse(hn::Lt(part, longest), part, longest), constant(0.4));
    }

    /// Whether a tangent in a crossing of this width will probably tell the root. For a smooth function the
    /// enclosure's error stands for a second derivative of about 4 width / h^2 in parts of the slope; the
    /// middle misses the root by a small part of the width, the tangent by the square of that. The limits
    /// were found by trial.
    HWY_INLINE Mask isStraight(Vector width) const {
        const Vector cube = hn::Mul(hn::Mul(width, width), width);
        return hn::And(hn::Le(width, hn::Mul(h, constant(0.15))),
                       hn::Le(cube, hn::Mul(hn::Mul(tolerance, constant(16)), hn::Mul(h, h))));
    }

    /// The function is positive at the start of the piece (its sign is taken out).
    HWY_INLINE void signKnown(Mask where, Mask opposite, Vector last, Vector upward, Vector end) {
        const Vector e = error;
        const Mask noRoot = hn::And(where, hn::Gt(hn::Sub(end, e), hn::Zero(MarchTag())));
        // The lower bound meets 0 here; up to there no root is possible.
        const Vector part = unitClamp(hn::Sub(place(hn::Sub(upward, e)), constant(4 * unit)));
        const Vector freeLength = hn::IfThenElse(noRoot, h, hn::Mul(part, h));
        const Mask narrowing = hn::And(hn::AndNot(noRoot, where), opposite);
        const Vector width = hn::Sub(last, freeLength);
        const Mask narrow = hn::And(narrowing, hn::Le(width, tolerance));
        // Where the sign is open, a crossing begins at the start of the piece.
        low = hn::Add(t, hn::IfThenElseZero(where, freeLength));
        raise(MarchEvent::crossing, narrow);
        if constexpr (plain)
            if (brackets) raise(MarchEvent::bracket, hn::And(narrowing, isStraight(width)));
        const Mask undecided = hn::AndNot(hn::Or(noRoot, narrowing), where);
        const Mask stuck = hn::And(undecided, hn::Le(h, resolution));
        if constexpr (!plain) signPlace = hn::IfThenElse(stuck, hn::Add(t, freeLength), signPlace);
        raise(MarchEvent::unresolved, stuck);
        // The root is mostly close to the middle, where the enclosure's line is 0: what holds a little more
        // than half of the crossing will mostly do, and has a third of the error.
        const Vector shorter = hn::Mul(
            width, hn::IfThenElse(hn::Lt(width, hn::Mul(h, constant(0.6))), constant(0.6), constant(0.5)));
        const Mask moving = hn::And(where, live);
        Vector length = shorter;
        if (!hn::AllFalse(MarchTag(), hn::AndNot(narrowing, moving))) {
            // The lower bound is 0 where an undecided piece is left.
            const Vector ahead = nextPart(hn::IfThenElse(noRoot, end, e));
            length = hn::IfThenElse(narrowing, shorter, hn::Mul(h, ahead));
        }
        advance(moving, freeLength);
        if constexpr (!plain) signPlace = hn::IfThenElse(moving, t, signPlace);
        h = hn::IfThenElse(moving, length, h);
    }

    /// The sign at the start is not certain; the numbers are relative to the last certain one.
    HWY_INLINE void signOpen(Mask where, Mask known, Mask opposite, Vector last, Vector upward) {
        const Vector zero = hn::Zero(MarchTag());
        // The sign was certain just before, and is the opposite at the end.
        const Mask before = hn::And(hn::And(where, known), hn::Ne(sign, zero));
        Mask flips = hn::And(before, hn::And(opposite, hn::Le(last, tolerance)));
        if constexpr (!plain) flips = hn::And(flips, hn::Eq(signPlace, t));
        raise(MarchEvent::crossing, flips);
        Mask stuck = hn::And(where, hn::Le(h, resolution));
        if constexpr (!plain) {
            // Values within an error that does not shrink with the length any more: pieces of this one would
            // stay open too.
            const Mask within = hn::Le(hn::Add(hn::Abs(upward), hn::Abs(slope)), error);
            const Mask lasting = hn::And(hn::Gt(unresolvedError, zero),
                                         hn::Le(error, hn::Add(unresolvedError, unresolvedError)));
            stuck = hn::Or(stuck, hn::And(hn::And(where, known), hn::And(within, lasting)));
        }
        raise(MarchEvent::unresolved, stuck);
        const Mask wild = hn::Or(hn::Not(known), hn::Gt(error, hn::Mul(hn::Abs(upward), constant(16))));
        const Vector factor = hn::IfThenElse(wild, constant(0.2), constant(0.45));
        h = hn::IfThenElse(hn::And(where, live), hn::Mul(h, factor), h);
    }
};

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
