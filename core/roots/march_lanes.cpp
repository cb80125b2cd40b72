// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/march_lanes.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/roots/march_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, batchLanes>;
using Vector = hn::Vec<Doubles>;
using Mask = hn::Mask<Doubles>;

constexpr double unit = std::numeric_limits<double>::epsilon();

HWY_INLINE Vector constant(double value) { return hn::Set(Doubles(), value); }

using Codes = hn::Rebind<std::int32_t, Doubles>;
static_assert(sizeof(MarchEvent) == sizeof(std::int32_t));

/// The lanes of one vector while they take one step. `live` are those without an event so far. Hardly a
/// branch: what happens to one of several lanes cannot be foreseen.
class Step {
  public:
    Step(RayPieces& pieces, MarchLanes& lanes, std::size_t first)
        : pieces_(pieces),
          lanes_(lanes),
          i_(first),
          t(load(pieces.start)),
          h(load(pieces.length)),
          far(load(lanes.far)),
          resolution(load(lanes.resolution)),
          tolerance(load(lanes.tolerance)),
          sign(load(lanes.sign)),
          signPlace(load(lanes.signPlace)) {}

    /// The form a + b s + [-e, e], negative inside; NaN and infinite errors allowed.
    HWY_INLINE void take(Vector a, Vector b, Vector e) {
        const Vector zero = hn::Zero(Doubles());
        const Vector infinite = constant(std::numeric_limits<double>::infinity());
        const Mask known = hn::Lt(hn::Abs(e), infinite);
        raise(MarchEvent::undefined, hn::Eq(e, hn::Neg(infinite)));
        const Vector atStart = hn::Sub(a, b);
        const Mask certain =
            hn::And(live_, hn::And(known, hn::Gt(hn::Mul(hn::Abs(atStart), constant(1 - 4 * unit)), e)));
        const Vector found = hn::CopySign(constant(1), atStart);
        const Mask fresh = hn::Eq(sign, zero);
        const Mask watched = hn::Ne(load(lanes_.watched), zero);
        const Mask differs = hn::Ne(found, sign);
        const Mask news = hn::And(certain, hn::And(differs, hn::Or(hn::Not(fresh), watched)));
        raise(MarchEvent::newSign, news);
        const Mask marching = hn::And(certain, live_);
        sign = hn::IfThenElse(marching, found, sign);
        signPlace = hn::IfThenElse(marching, t, signPlace);
        store(hn::IfThenZeroElse(marching, load(lanes_.noise)), lanes_.noise);

        const Vector upward = hn::Mul(a, sign), slope = hn::Mul(b, sign);
        const Vector end = hn::Add(upward, slope);
        const Mask opposite = hn::Lt(hn::Add(end, e), zero);
        const Vector last =
            hn::Mul(unitClamp(hn::Add(place(hn::Add(upward, e), slope), constant(4 * unit))), h);
        store(found, lanes_.newSign);
        store(slope, lanes_.slope);
        store(e, lanes_.error);
        store(hn::Add(t, last), lanes_.high);
        signOpen(hn::AndNot(certain, live_), known, opposite, last, upward, slope, e);
        signKnown(hn::And(marching, live_), opposite, last, upward, slope, end, e);
    }

    /// Writes the lanes back; those with an event that keeps its piece only count the evaluation.
    HWY_INLINE bool finish(MarchEvent* events) {
        const Vector evaluations = hn::Add(load(lanes_.evaluations), constant(1));
        store(evaluations, lanes_.evaluations);
        const Mask ended = hn::And(live_, hn::Ge(t, far));
        raise(MarchEvent::reachedEnd, ended);
        raise(MarchEvent::exhausted, hn::And(live_, hn::Ge(evaluations, load(lanes_.budget))));
        const Vector length = hn::Min(hn::Max(h, resolution), hn::Sub(far, t));
        store(t, pieces_.start);
        store(length, pieces_.length);
        store(sign, lanes_.sign);
        store(signPlace, lanes_.signPlace);
        const Codes codes;
        hn::StoreU(hn::DemoteTo(codes, events_), codes, reinterpret_cast<std::int32_t*>(events + i_));
        return !hn::AllTrue(Doubles(), live_);
    }

  private:
    HWY_INLINE Vector load(const MarchLanes::Lanes& lanes) const { return hn::LoadU(Doubles(), &lanes[i_]); }
    HWY_INLINE void store(Vector value, MarchLanes::Lanes& lanes) const {
        hn::StoreU(value, Doubles(), &lanes[i_]);
    }

    HWY_INLINE void raise(MarchEvent event, Mask where) {
        events_ = hn::IfThenElse(hn::And(where, live_), constant(static_cast<double>(event)), events_);
        live_ = hn::AndNot(where, live_);
    }

    /// Where value + slope s is 0, as a part of the piece, not limited to it.
    static HWY_INLINE Vector place(Vector value, Vector slope) {
        return hn::Mul(hn::Sub(constant(1), hn::Div(value, slope)), constant(0.5));
    }
    /// Between 0 and 1; 0 for what is not a number.
    static HWY_INLINE Vector unitClamp(Vector part) {
        const Vector zero = hn::Zero(Doubles());
        return hn::Min(hn::IfThenElse(hn::Gt(part, zero), part, zero), constant(1));
    }

    /// The end is reached exactly, whatever the sum of the pieces is rounded to.
    HWY_INLINE void advance(Mask where, Vector length) {
        const Vector rest = hn::Sub(far, t);
        const Mask through = hn::Or(hn::Ge(length, rest),
                                    hn::Lt(hn::Sub(rest, length), hn::Mul(resolution, constant(1.0 / 64))));
        t = hn::IfThenElse(where, hn::IfThenElse(through, far, hn::Add(t, length)), t);
    }

    /// How long the next piece had better be, in parts of this one, where the function is about `value` and
    /// goes on with the slope 2 `slope` a part: up to where the form would lose its sign if its error grows
    /// with the square of the length. Only speed depends on it; the factors were found by trial.
    static HWY_INLINE Vector nextPart(Vector value, Vector slope, Vector e) {
        const Vector error = hn::Mul(e, constant(1.5));
        const Vector root = hn::Sqrt(hn::MulAdd(slope, slope, hn::Mul(error, value)));
        const Vector part = hn::Div(hn::Add(slope, root), error);
        const Vector longest = constant(1.8);
        return hn::Max(hn::IfThenElse(hn::Lt(part, longest), part, longest), constant(0.4));
    }

    /// The function is positive at the start of the piece (its sign is taken out).
    HWY_INLINE void signKnown(Mask where, Mask opposite, Vector last, Vector upward, Vector slope, Vector end,
                              Vector e) {
        const Mask noRoot = hn::And(where, hn::Gt(hn::Sub(end, e), hn::Zero(Doubles())));
        // The lower bound meets 0 here; up to there no root is possible.
        const Vector part = unitClamp(hn::Sub(place(hn::Sub(upward, e), slope), constant(4 * unit)));
        const Vector freeLength = hn::IfThenElse(noRoot, h, hn::Mul(part, h));
        const Mask narrowing = hn::And(hn::AndNot(noRoot, where), opposite);
        const Vector width = hn::Sub(last, freeLength);
        const Mask narrow = hn::And(narrowing, hn::Le(width, tolerance));
        // Where the sign is open, a crossing begins at the start of the piece.
        store(hn::Add(t, hn::IfThenElseZero(where, freeLength)), lanes_.low);
        raise(MarchEvent::crossing, narrow);
        const Mask undecided = hn::AndNot(hn::Or(noRoot, narrowing), where);
        const Mask stuck = hn::And(undecided, hn::Le(h, resolution));
        signPlace = hn::IfThenElse(stuck, hn::Add(t, freeLength), signPlace);
        raise(MarchEvent::unresolved, stuck);
        const Vector shorter =
            hn::IfThenElse(hn::Lt(width, hn::Mul(h, constant(0.6))), width, hn::Mul(width, constant(0.5)));
        // The lower bound is 0 where an undecided piece is left.
        const Vector ahead = nextPart(hn::IfThenElse(noRoot, end, e), slope, e);
        const Mask moving = hn::And(where, live_);
        advance(moving, freeLength);
        signPlace = hn::IfThenElse(moving, t, signPlace);
        const Vector length = hn::IfThenElse(narrowing, shorter, hn::Mul(h, ahead));
        h = hn::IfThenElse(moving, length, h);
    }

    /// The sign at the start is not certain; the numbers are relative to the last certain one.
    HWY_INLINE void signOpen(Mask where, Mask known, Mask opposite, Vector last, Vector upward, Vector slope,
                             Vector e) {
        const Vector zero = hn::Zero(Doubles());
        // The sign was certain just before, and is the opposite at the end.
        const Mask flips = hn::And(hn::And(where, hn::And(known, hn::Ne(sign, zero))),
                                   hn::And(hn::Eq(signPlace, t), hn::And(opposite, hn::Le(last, tolerance))));
        raise(MarchEvent::crossing, flips);
        // Values within an error that does not shrink with the length any more: pieces of this one would stay
        // open too.
        const Vector noise = load(lanes_.noise);
        const Mask blurred = hn::And(
            hn::And(known, hn::Gt(noise, zero)),
            hn::And(hn::Le(hn::Add(hn::Abs(upward), hn::Abs(slope)), e), hn::Le(e, hn::Add(noise, noise))));
        const Mask stuck = hn::And(where, hn::Or(hn::Le(h, resolution), blurred));
        raise(MarchEvent::unresolved, stuck);
        const Mask wild = hn::Or(hn::Not(known), hn::Gt(e, hn::Mul(hn::Abs(upward), constant(16))));
        const Vector factor = hn::IfThenElse(wild, constant(0.2), constant(0.45));
        h = hn::IfThenElse(hn::And(where, live_), hn::Mul(h, factor), h);
    }

    RayPieces& pieces_;
    MarchLanes& lanes_;
    std::size_t i_;
    Vector t, h, far, resolution, tolerance, sign, signPlace;
    Vector events_ = hn::Zero(Doubles());
    Mask live_ = hn::Eq(events_, events_);
};

bool marchAll(RayPieces& pieces, MarchLanes& lanes, const AffineLanes& forms, const SignRule& rule,
              std::size_t count, MarchEvent* events) {
    const Vector threshold = constant(rule.threshold);
    const Vector polarity = constant(rule.positivePolarity ? -1 : 1);
    bool any = false;
    for (std::size_t i = 0; i < count; i += hn::Lanes(Doubles())) {
        const Vector a = hn::LoadU(Doubles(), forms.center + i);
        const Vector b = hn::LoadU(Doubles(), forms.slope + i);
        // The rounding of center - threshold.
        const Vector e =
            hn::Add(hn::LoadU(Doubles(), forms.error + i), hn::Mul(hn::Abs(a), constant(2 * unit)));
        Step step(pieces, lanes, i);
        step.take(hn::Mul(hn::Sub(a, threshold), polarity), hn::Mul(b, polarity), e);
        any |= step.finish(events);
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
