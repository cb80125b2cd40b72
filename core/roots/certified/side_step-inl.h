// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. One step of MarchKernel's march: a vector of its rows, and along
// functions that jump.
#if defined(ISOSCOPE_ROOTS_SIDE_STEP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_ROOTS_SIDE_STEP_INL
#undef ISOSCOPE_ROOTS_SIDE_STEP_INL
#else
#define ISOSCOPE_ROOTS_SIDE_STEP_INL
#endif

#include <hwy/highway.h>

#include <limits>

#include "core/roots/certified/march_rows.h"
#include "core/roots/certified/march_step-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

using Vector = hn::Vec<MarchTag>;
using Mask = hn::Mask<MarchTag>;
using March = MarchKernel;

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double unit = std::numeric_limits<double>::epsilon();

HWY_INLINE Vector constant(double value) { return hn::Set(MarchTag(), value); }
HWY_INLINE Vector load(const double* from) { return hn::LoadU(MarchTag(), from); }
HWY_INLINE void save(Vector value, double* to) { hn::StoreU(value, MarchTag(), to); }

/// How well the place of a jump has to be known, and how close to a wall it is the wall's (GeneralSearch).
HWY_INLINE Vector finestPlace(Vector resolution) { return hn::Mul(resolution, constant(1.0 / 256)); }

/// The rows from `k` on, before a step.
HWY_INLINE MarchStep<true> loadStep(const MarchRows& rows, std::size_t k, Mask alive,
                                    const PlainMarchRules& rules) {
    const auto column = [&](March::Column c) HWY_ATTR { return load(rows.state[c] + k); };
    MarchStep<true> step;
    step.live = alive;
    step.t = column(March::start), step.h = column(March::length), step.far = column(March::far);
    step.sign = column(March::sign), step.watched = column(March::watched);
    step.resolution = column(March::resolution), step.tolerance = column(March::tolerance);
    step.brackets = rules.brackets;
    return step;
}

HWY_INLINE void saveStep(const MarchStep<true>& step, const MarchRows& rows, std::size_t k) {
    save(step.t, rows.state[March::start] + k);
    save(step.nextLength(), rows.state[March::length] + k);
    save(step.sign, rows.state[March::sign] + k);
}

/// The lanes of a vector of pieces that end where the first side of a jump does.
struct SideStep {
    MarchStep<true> step;
    Vector t, length;  ///< of the whole piece
    Vector low, high;  ///< from its start to where the side may end, and certainly has
    Mask ends, holds;  ///< whether it does on the piece, and whether the sign lasts until then for certain
    Vector reach;      ///< how long a piece may be whose error is no larger than what the function changes
    Mask here;         ///< of pass(): whether it has come there
    Vector hop, behind, toldJump, toldSide;  ///< as in MarchKernel::Column

    HWY_INLINE SideStep(const MarchStep<true>& whole, const MarchRows& rows, std::size_t k) : step(whole) {
        hop = load(rows.state[March::hop] + k), behind = load(rows.state[March::behind] + k);
        toldJump = load(rows.state[March::toldJump] + k), toldSide = load(rows.state[March::toldSide] + k);
    }

    /// Encloses the function up to the first jump, and takes a step.
    HWY_INLINE void take(Vector a, Vector b, Vector e, Vector firstLow, Vector firstHigh, Mask open) {
        const Vector one = constant(1), half = constant(0.5), zero = hn::Zero(MarchTag());
        t = step.t, length = step.h;
        ends = hn::Lt(firstLow, one);
        const Vector part = hn::IfThenElse(ends, hn::Mul(half, hn::Add(one, firstLow)), one);
        const Vector slope = hn::Mul(b, part);
        const Vector rounding = hn::Mul(hn::Add(hn::Abs(a), hn::Abs(b)), constant(4 * unit));
        const Vector error = hn::IfThenElse(ends, hn::Add(e, rounding), e);
        low = hn::Mul(part, length);
        high = hn::Mul(hn::Mul(half, hn::Add(one, firstHigh)), length);
        step.h = low;
        const Mask waiting = hn::And(open, step.live);
        step.live = hn::AndNot(open, step.live);
        step.take(hn::Add(hn::Sub(a, b), slope), slope, error);
        const Vector change = hn::Add(hn::Abs(b), hn::Abs(b));
        reach = hn::IfThenElse(hn::Gt(e, zero), hn::Mul(length, hn::Sqrt(hn::Div(change, e))), step.far);
        const Vector atJump = hn::Mul(hn::MulAdd(b, firstHigh, a), step.sign);
        holds = hn::Gt(atJump, error);
        // An error that is as large only because the piece is so much longer than what counts of it.
        const Mask lengthy = hn::Gt(length, hn::Mul(step.resolution, constant(4)));
        const Mask coarse = hn::And(was(MarchEvent::unresolved), hn::And(ends, lengthy));
        const Mask crossed = hn::And(flipped(), hn::Gt(hop, finestPlace(step.resolution)));
        const Mask back = hn::Or(coarse, crossed);
        step.events = hn::IfThenZeroElse(back, step.events);
        step.live = hn::Or(step.live, hn::Or(waiting, back));
        step.h = hn::IfThenElse(
            coarse, hn::Min(hn::Max(hn::Add(low, low), step.resolution), hn::Mul(length, half)), step.h);
        // The jump through the threshold has to be found more exactly.
        step.h = hn::IfThenElse(crossed, hn::Mul(hop, constant(1.25)), step.h);
        behind = hn::IfThenElse(crossed, hn::Max(behind, length), behind);
        toldJump = hn::IfThenElse(crossed, constant(SideLanes::noJump), toldJump);
        hop = hn::IfThenZeroElse(crossed, hop);
        // Behind a wall in a jump, sides can be read once the error, which goes with the square of the
        // length, is less than what lies between. Sides that are open for other reasons take long pieces.
        const Mask brief = hn::Lt(hn::Mul(length, constant(4)), hn::Sub(step.far, t));
        const Mask entering = hn::And(hn::And(waiting, brief), hn::Ge(hop, finestPlace(step.resolution)));
        const Vector shorter =
            hn::IfThenElse(entering, hn::Max(hn::Sqrt(hn::Mul(length, hop)), step.resolution), length);
        step.h = hn::IfThenElse(waiting, hn::Min(shorter, hn::Mul(length, constant(0.45))), step.h);
        behind = hn::IfThenElse(entering, hn::Max(behind, length), hn::IfThenZeroElse(waiting, behind));
        giveUp(hn::And(waiting, hn::Le(length, step.resolution)));
    }

    /// Whether the sign has changed by the side behind a jump.
    HWY_INLINE Mask flipped() const {
        return hn::And(was(MarchEvent::newSign), hn::And(hn::Gt(hop, hn::Zero(MarchTag())), known()));
    }
    HWY_INLINE Mask was(MarchEvent event) const {
        return hn::Eq(step.events, constant(static_cast<double>(event)));
    }

    /// Goes on behind a jump, or looks at it again in a shorter piece.
    HWY_INLINE void pass(Mask open, Vector nextJump, Vector nextSide) {
        const Vector zero = hn::Zero(MarchTag()), none = constant(SideLanes::noJump);
        here = hn::AndNot(open, hn::And(step.live, hn::And(ends, hn::Ge(step.t, hn::Add(t, low)))));
        const Vector reading = hn::Add(t, hop);
        // As it was, to the last bit, where the line has not moved.
        hop = hn::IfThenElse(hn::Gt(step.t, t), hn::Max(hn::Sub(reading, step.t), zero), hop);
        const Mask behindIt = hn::Eq(hop, zero);
        toldJump = hn::IfThenElse(behindIt, none, toldJump);
        const Mask resumes = hn::AndNot(here, hn::And(step.live, hn::And(behindIt, hn::Gt(step.t, t))));
        // Errors grow with the square of the length: longer pieces would hold the jump again.
        const Vector possible = hn::Min(behind, reach);
        step.h = hn::IfThenElse(resumes, hn::Max(step.h, possible), step.h);
        const Mask passes =
            hn::Ge(hn::Add(step.t, hn::Mul(length, constant(1.0 / 1024))), hn::Add(t, length));
        const Mask longer = hn::And(passes, hn::Lt(step.h, behind));
        behind = hn::IfThenZeroElse(hn::AndNot(longer, resumes), behind);
        // What is told holds no further than the piece did.
        const Mask told = hn::AndNot(here, hn::And(step.live, hn::Ge(toldJump, zero)));
        const Vector rest = hn::Sub(hn::Add(t, length), step.t);
        step.h = hn::IfThenElse(told, hn::Min(step.h, rest), step.h);
        giveUp(hn::And(told, hn::Lt(rest, step.resolution)));
        // A jump in the wall where the line leaves: nothing is behind it.
        const Mask atWall = hn::And(here, hn::Le(hn::Sub(step.far, step.t), finestPlace(step.resolution)));
        step.t = hn::IfThenElse(atWall, step.far, step.t);
        here = hn::AndNot(atWall, here);
        if (!hn::AllFalse(MarchTag(), here)) passJump(reading, nextJump, nextSide);
        // No room is left before the wall.
        giveUp(hn::And(step.live, hn::Gt(hn::Mul(hop, constant(4)), hn::Sub(step.far, step.t))));
    }

  private:
    HWY_INLINE Mask known() const { return hn::Ne(step.sign, hn::Zero(MarchTag())); }
    /// What is not plain is left to others, from where the step began.
    HWY_INLINE void giveUp(Mask where) {
        const Mask those = hn::And(where, step.live);
        step.t = hn::IfThenElse(those, hn::Min(t, step.t), step.t);
        step.raise(MarchEvent::unresolved, those);
    }
    /// Where the sign lasts as long as the side may, the piece behind is enclosed on the next one: read right
    /// behind a place that is as exact as doubles are, else told, up to where it is known to hold. `reading`
    /// is where the sides were read.
    HWY_INLINE void passJump(Vector reading, Vector nextJump, Vector nextSide) {
        const Vector zone = hn::Sub(high, low), rest = hn::Sub(length, low);
        const Vector grain = hn::Mul(step.far, constant(32 * unit));
        const Mask exact = hn::Le(zone, grain);
        const Mask reads = hn::And(hn::And(here, holds), exact);
        const Mask tells = hn::AndNot(
            exact, hn::And(hn::And(here, holds),
                           hn::And(hn::Ge(rest, step.resolution), hn::Ge(rest, hn::Mul(zone, constant(4))))));
        const Mask through = hn::Or(reads, tells);
        const Mask again = hn::AndNot(through, hn::And(here, hn::Gt(length, step.resolution)));
        giveUp(hn::AndNot(hn::Or(again, through), here));
        // Close to the wall, its value decides.
        giveUp(hn::And(here, hn::Ge(step.t, step.far)));
        hop = hn::IfThenElse(reads, hn::Max(zone, hn::Mul(grain, constant(0.5))),
                             hn::IfThenElse(tells, zone, hop));
        toldJump = hn::IfThenElse(tells, nextJump, toldJump);
        toldSide = hn::IfThenElse(tells, nextSide, toldSide);
        const Vector wish = hn::Max(hn::Max(rest, behind), step.h);
        behind = hn::IfThenElse(again, hn::Max(behind, rest), hn::IfThenZeroElse(reads, behind));
        const Vector shorter = hn::Min(hn::Mul(zone, constant(1.25)), hn::Mul(length, constant(0.5)));
        // From a little before the jump: where it begins, its own side could not be read.
        const Vector back = hn::Mul(hn::Max(shorter, step.resolution), constant(0.25));
        const Vector before = hn::Max(hn::Sub(step.t, back), hn::Min(reading, step.t));
        step.t = hn::IfThenElse(again, before, step.t);
        step.h =
            hn::IfThenElse(again, shorter, hn::IfThenElse(tells, rest, hn::IfThenElse(reads, wish, step.h)));
    }
};

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
