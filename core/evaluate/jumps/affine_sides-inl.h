// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. Affine forms on the sides of jumps that hold at one place (SideLanes).
#if defined(ISOSCOPE_EVALUATE_AFFINE_SIDES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_AFFINE_SIDES_INL
#undef ISOSCOPE_EVALUATE_AFFINE_SIDES_INL
#else
#define ISOSCOPE_EVALUATE_AFFINE_SIDES_INL
#endif

#include <hwy/highway.h>

#include <array>
#include <numbers>

#include "core/evaluate/jumps/affine_sides.h"
#include "core/evaluate/jumps/affine_whole-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// The rules of AffineAlgebra for operations that jump, but on the side of SideLanes::readAt.
class AffineSideAlgebra : public AffineWholeAlgebra {
  public:
    /// For the first `count` lanes.
    AffineSideAlgebra(SideLanes& sides, std::size_t count) : sides_(&sides) {
        sides.seen.assign(sides.jumpOf.size(), false);
        sides.low.fill(SideLanes::beyond);
        sides.high.fill(SideLanes::beyond);
        sides.open.fill(0);
        sides.blind.fill(0);
        sides.crowded.fill(0);
        passed_.fill(0);
        for (std::size_t i = 0; i < count; ++i) wide_ = wide_ || sides.readAt[i] + 1 > sides.grain[i];
    }

    /// Before instruction `number` of the workspace's tape, as for AffineAlgebra.
    void begin(const TapeWorkspace& workspace, std::size_t number) {
        AffineWholeAlgebra::begin(workspace, number);
        const std::uint32_t jump =
            number < sides_->jumpOf.size() ? sides_->jumpOf[number] : CaseLanes::notNumbered;
        jump_ = jump;
        isFirst_ = jump == CaseLanes::notNumbered || !sides_->seen[jump];
        if (jump != CaseLanes::notNumbered) sides_->seen[jump] = true;
    }

    /// An operation on the lanes from `lane` on; operands that it does not have are not read.
    HWY_INLINE Number run(Operation operation, const std::array<Number, 4>& p, std::size_t lane) {
        switch (operation) {
            case Operation::add: return exactSum(p[0], p[1]);
            case Operation::subtract: return exactSum(p[0], negated(p[1]));
            case Operation::multiply: return exactProduct(p[0], p[1]);
            case Operation::divide: return exactQuotient(p[0], p[1]);
            case Operation::floor: return floorOf(p[0], lane);
            case Operation::ceiling: return ceilingOf(p[0], lane);
            case Operation::truncate: return truncated(p[0], lane);
            case Operation::fraction: return fractionOf(p[0], lane);
            case Operation::integerDivide: return truncated(stepQuotient(p[0], p[1]), lane);
            case Operation::remainder: return remainderOf(p[0], p[1], lane);
            case Operation::arcTangent2: return angle(p[0], p[1], lane);
            case Operation::equal: return equality(equal(p[0], p[1]), 0, p[0], p[1], lane);
            case Operation::notEqual: return equality(notEqual(p[0], p[1]), 1, p[0], p[1], lane);
            case Operation::less: return compared(less(p[0], p[1]), p[1], p[0], lane);
            case Operation::lessEqual: return compared(lessEqual(p[0], p[1]), p[1], p[0], lane);
            case Operation::greater: return compared(greater(p[0], p[1]), p[0], p[1], lane);
            case Operation::greaterEqual: return compared(greaterEqual(p[0], p[1]), p[0], p[1], lane);
            case Operation::logicalAnd: return truth(logicalAnd(p[0], p[1]), lane);
            case Operation::logicalOr: return truth(logicalOr(p[0], p[1]), lane);
            case Operation::select3: return chosen(p[0], p[1], p[2], lane);
            default: return chosenOfThree(p, lane);
        }
    }

  private:
    static HWY_INLINE Vector lanesOf(const SideLanes::Lanes& lanes, std::size_t lane) {
        return hn::LoadU(Doubles(), &lanes[lane]);
    }
    static HWY_INLINE void put(Vector value, SideLanes::Lanes& lanes, std::size_t lane) {
        hn::StoreU(value, Doubles(), &lanes[lane]);
    }

    /// An operand where the sides are read.
    HWY_INLINE Number atReading(const Number& p, std::size_t lane) const {
        const Vector along = hn::Mul(p.b, lanesOf(sides_->readAt, lane)), a = hn::Add(p.a, along);
        const Vector rounding =
            hn::Mul(hn::Add(hn::Abs(a), hn::Abs(along)), constantVector(2 * roundingUnit));
        return {a, zeroVector(), hn::IfThenElse(isExact(p), p.e, hn::Add(p.e, rounding))};
    }

    /// Lanes of `where` cannot be read.
    HWY_INLINE void open(Mask where, std::size_t lane) { mark(where, sides_->open, lane); }
    HWY_INLINE void mark(Mask where, SideLanes::Lanes& marks, std::size_t lane) {
        if (HWY_LIKELY(hn::AllFalse(Doubles(), where))) return;
        put(hn::IfThenElse(where, constantVector(1), lanesOf(marks, lane)), marks, lane);
    }

    /// In the lanes of `where` a side holds while the operand is between the two bounds, as it is at the
    /// reading; then it is the one above or below. With the slope of its form it can leave them in one
    /// direction only, forward; and it may have come through the other one before.
    HWY_INLINE void holdBetween(Mask where, const Number& p, Vector least, Vector most, Vector above,
                                Vector below, std::size_t lane) {
        if (!isFirst_) return;  // All is known of this jump.
        const Doubles d;
        const Mask rises = hn::Gt(p.b, zeroVector());
        const Vector one = constantVector(1);
        const Vector next = hn::IfThenElse(rises, most, least), slope = hn::Abs(p.b);
        const Vector rounding =
            hn::Mul(hn::Add(hn::Abs(next), hn::Abs(p.a)), constantVector(4 * roundingUnit));
        const Vector width =
            hn::Add(hn::Div(hn::Add(p.e, rounding), slope), constantVector(16 * roundingUnit));
        const Vector middle = hn::Div(hn::Sub(next, p.a), p.b);
        if (HWY_UNLIKELY(wide_)) notePassed(where, p, hn::IfThenElse(rises, least, most), rises, lane);
        // Bounds that are infinite are beyond all pieces.
        const Mask sloping = hn::And(where, hn::Gt(slope, zeroVector()));
        const Mask ends = hn::And(sloping, hn::Lt(hn::Sub(middle, width), one));
        if (hn::AllFalse(d, ends)) return;
        const Vector beyond = constantVector(SideLanes::beyond);
        const Vector readAt = lanesOf(sides_->readAt, lane);
        const Vector low = hn::IfThenElse(ends, hn::Max(hn::Sub(middle, width), readAt), beyond);
        const Vector high = hn::IfThenElse(ends, hn::Min(hn::Add(middle, width), one), beyond);
        const Vector oldLow = lanesOf(sides_->low, lane), oldHigh = lanesOf(sides_->high, lane);
        const Mask together = hn::And(ends, hn::Ge(hn::Min(high, oldHigh), hn::Max(low, oldLow)));
        const Mask sooner = hn::Lt(low, oldLow);
        const Vector first = hn::IfThenElse(sooner, high, oldHigh);
        put(hn::IfThenElse(sooner, constantVector(jump_), lanesOf(sides_->nextJump, lane)), sides_->nextJump,
            lane);
        put(hn::IfThenElse(sooner, hn::IfThenElse(rises, above, below), lanesOf(sides_->nextSide, lane)),
            sides_->nextSide, lane);
        const Vector start = hn::Min(low, oldLow),
                     end = hn::IfThenElse(together, hn::Max(high, oldHigh), first);
        put(start, sides_->low, lane);
        put(end, sides_->high, lane);
        // Also where one of them is known exactly: which comes first is open.
        const Mask crowded = hn::And(together, hn::Gt(hn::Sub(end, start), lanesOf(sides_->grain, lane)));
        if (hn::AllFalse(d, crowded)) return;
        put(hn::IfThenElse(crowded, one, lanesOf(sides_->crowded, lane)), sides_->crowded, lane);
    }

    /// What lies before the reading counts as being on its side, which one jump can be the reason for, but
    /// several only where they cannot be told apart.
    HWY_NOINLINE void notePassed(Mask where, const Number& p, Vector passed, Mask rises, std::size_t lane) {
        const Vector start = hn::Sub(p.a, p.b),
                     direction = hn::IfThenElse(rises, constantVector(1), constantVector(-1));
        const Vector rounding =
            hn::Mul(hn::Add(hn::Abs(start), hn::Abs(p.b)), constantVector(4 * roundingUnit));
        const Vector above = hn::Sub(hn::Mul(hn::Sub(start, passed), direction), hn::Add(p.e, rounding));
        const Mask finite = hn::Lt(hn::Abs(passed), constantVector(unlimited));
        const Mask reaches = hn::And(hn::And(where, finite), hn::Not(hn::Gt(above, zeroVector())));
        const Mask wide =
            hn::Gt(hn::Add(lanesOf(sides_->readAt, lane), constantVector(1)), lanesOf(sides_->grain, lane));
        const Vector before = lanesOf(passed_, lane), one = constantVector(1);
        put(hn::IfThenElse(reaches, hn::Add(before, one), before), passed_, lane);
        mark(hn::And(hn::And(reaches, wide), hn::Ge(before, one)), sides_->blind, lane);
    }

    /// The lanes that are told the side of the jump at hand.
    HWY_INLINE Mask told(std::size_t lane) const {
        return hn::Eq(lanesOf(sides_->toldJump, lane), constantVector(jump_));
    }

    /// A step of a staircase at the reading, if it is certain; then it lasts between the bounds.
    struct Step {
        Vector step;
        Mask read;
    };
    /// `boundsOf` tells the bounds of a step.
    template <class Bounds>
    HWY_INLINE Step stepOf(const Number& p, Vector first, Vector last, const Bounds& boundsOf,
                           std::size_t lane) {
        const Mask known = isKnown(p), told = this->told(lane);
        const Mask read = hn::And(known, hn::Or(told, hn::Eq(first, last)));
        const Vector step = hn::IfThenElse(told, lanesOf(sides_->toldSide, lane), first);
        const VectorRange bounds = boundsOf(step);
        const Vector one = constantVector(1);
        holdBetween(read, p, bounds.low, bounds.high, hn::Add(step, one), hn::Sub(step, one), lane);
        open(hn::AndNot(read, known), lane);
        return {step, read};
    }
    HWY_INLINE Step floorStep(const Number& p, const VectorRange& range, std::size_t lane) {
        const auto bounds = [](Vector step) HWY_ATTR {
            return VectorRange{step, hn::Add(step, constantVector(1))};
        };
        return stepOf(p, hn::Floor(range.low), hn::Floor(range.high), bounds, lane);
    }
    HWY_INLINE Number floorOf(const Number& p, std::size_t lane) {
        const Number there = atReading(p, lane);
        const Step step = floorStep(p, tight(there, clippedRange(there, domain(0))), lane);
        return sideOr(step.read, exactNumber(step.step), [&]() HWY_ATTR { return floor(p); });
    }
    HWY_INLINE Number fractionOf(const Number& p, std::size_t lane) {
        const Number there = atReading(p, lane);
        const Step step = floorStep(p, tight(there, rangeOf(there)), lane);
        const Number side = exactSum(p, exactNumber(hn::Neg(step.step)));
        return sideOr(step.read, side, [&]() HWY_ATTR { return fraction(p); });
    }
    HWY_INLINE Number ceilingOf(const Number& p, std::size_t lane) {
        const Number there = atReading(p, lane);
        const VectorRange range = tight(there, clippedRange(there, domain(0)));
        const auto bounds = [](Vector step) HWY_ATTR {
            return VectorRange{hn::Sub(step, constantVector(1)), step};
        };
        const Step step = stepOf(p, hn::Ceil(range.low), hn::Ceil(range.high), bounds, lane);
        return sideOr(step.read, exactNumber(step.step), [&]() HWY_ATTR { return ceiling(p); });
    }
    /// Toward zero: as floor above 0, as ceiling below.
    HWY_INLINE Step truncationOf(const Number& p, std::size_t lane) {
        const Number there = atReading(p, lane);
        const VectorRange range = tight(there, rangeOf(there));
        const auto bounds = [](Vector step) HWY_ATTR {
            const Vector one = constantVector(1), zero = zeroVector();
            return VectorRange{hn::IfThenElse(hn::Gt(step, zero), step, hn::Sub(step, one)),
                               hn::IfThenElse(hn::Lt(step, zero), step, hn::Add(step, one))};
        };
        return stepOf(p, hn::Trunc(range.low), hn::Trunc(range.high), bounds, lane);
    }
    HWY_INLINE Number truncated(const Number& p, std::size_t lane) {
        const Step step = truncationOf(p, lane);
        // Beyond 32 bits the value is another one.
        const Mask fits = hn::Lt(hn::Abs(step.step), constantVector(2147483647.0));
        return sideOr(hn::And(step.read, fits), exactNumber(step.step),
                      [&]() HWY_ATTR { return truncate(p); });
    }
    HWY_INLINE Number remainderOf(const Number& p, const Number& q, std::size_t lane) {
        const Number quotient = stepQuotient(p, q);
        const Step step = truncationOf(quotient, lane);
        const Number side = stepRest(p, q, step.step);
        return sideOr(step.read, side, [&]() HWY_ATTR { return AffineAlgebra::remainderOf(p, q, quotient); });
    }

    /// Whether an operand is above 0 at the reading, or below; then it lasts as long. Of the lanes of
    /// `where`.
    struct Sign {
        Mask above, read;
    };
    HWY_INLINE Sign signOf(Mask where, const Number& p, std::size_t lane) {
        const VectorRange range = rangeOf(atReading(p, lane));
        const Vector zero = zeroVector(), infinite = constantVector(unlimited);
        const Mask told = hn::And(where, this->told(lane));
        const Mask toldAbove = hn::And(told, hn::Gt(lanesOf(sides_->toldSide, lane), zero));
        const Mask above = hn::Or(toldAbove, hn::AndNot(told, hn::And(where, hn::Gt(range.low, zero))));
        const Mask read = hn::Or(hn::Or(told, above), hn::And(where, hn::Lt(range.high, zero)));
        holdBetween(read, p, hn::IfThenElse(above, zero, hn::Neg(infinite)),
                    hn::IfThenElse(above, infinite, zero), constantVector(1), zero, lane);
        open(hn::AndNot(read, where), lane);
        return {above, read};
    }

    /// On the cut, seen from the other side: the angle of the opposite point and half a turn.
    HWY_INLINE Number angle(const Number& ordinate, const Number& abscissa, std::size_t lane) {
        const Mask known = hn::And(isKnown(ordinate), isKnown(abscissa));
        const VectorRange y = rangeOf(ordinate), x = rangeOf(abscissa);
        const Vector zero = zeroVector();
        const Mask cut =
            hn::And(hn::And(known, hn::Lt(x.high, zero)), hn::And(hn::Le(y.low, zero), hn::Ge(y.high, zero)));
        if (hn::AllFalse(Doubles(), cut)) return arcTangent2(ordinate, abscissa);
        const Sign sign = signOf(cut, ordinate, lane);
        const Vector pi = constantVector(std::numbers::pi);
        const Number halfTurn{hn::IfThenElse(sign.above, pi, hn::Neg(pi)), zero,
                              constantVector(2 * roundingUnit)};
        const Number angle = arcTangent2(chooseNumber(sign.read, negated(ordinate), ordinate),
                                         chooseNumber(sign.read, negated(abscissa), abscissa));
        return chooseNumber(sign.read, sumOf(angle, halfTurn), angle);
    }

    /// 1 where p is above q, 0 below, where `hull` leaves it open.
    HWY_INLINE Number compared(const Number& hull, const Number& p, const Number& q, std::size_t lane) {
        const Mask undecided = hn::AndNot(isExact(hull), hn::And(isKnown(p), isKnown(q)));
        if (hn::AllFalse(Doubles(), undecided)) return hull;
        const Sign sign = signOf(undecided, differenceOf(p, q), lane);
        const Vector value = hn::IfThenElse(sign.above, constantVector(1), zeroVector());
        return chooseNumber(sign.read, exactNumber(value), hull);
    }
    /// `different` on either side of equality.
    HWY_INLINE Number equality(const Number& hull, double different, const Number& p, const Number& q,
                               std::size_t lane) {
        const Mask undecided = hn::AndNot(isExact(hull), hn::And(isKnown(p), isKnown(q)));
        if (hn::AllFalse(Doubles(), undecided)) return hull;
        const Sign sign = signOf(undecided, differenceOf(p, q), lane);
        return chooseNumber(sign.read, exactNumber(constantVector(different)), hull);
    }
    HWY_INLINE Number truth(const Number& hull, std::size_t lane) {
        open(hn::AndNot(isExact(hull), isKnown(hull)), lane);
        return hull;
    }

    HWY_INLINE Number chosen(const Number& p, const Number& negative, const Number& otherwise,
                             std::size_t lane) {
        const VectorRange range = rangeOf(p);
        const Vector zero = zeroVector();
        const Mask either = hn::And(isKnown(p), hn::And(hn::Lt(range.low, zero), hn::Ge(range.high, zero)));
        const Number hull = select3(p, negative, otherwise);
        if (hn::AllFalse(Doubles(), either)) return hull;
        const Mask exact = isExact(p);
        const Sign sign = signOf(hn::AndNot(exact, either), p, lane);
        const Mask above = hn::Or(sign.above, hn::And(exact, hn::Ge(p.a, zero)));
        const Mask read = hn::Or(sign.read, hn::And(exact, either));
        return chooseNumber(read, chooseNumber(above, otherwise, negative), hull);
    }
    /// The value at 0 goes with the side that it equals, else with the higher one.
    HWY_INLINE Number chosenOfThree(const std::array<Number, 4>& p, std::size_t lane) {
        const VectorRange range = rangeOf(p[0]);
        const Vector zero = zeroVector();
        const Number hull = select4(p[0], p[1], p[2], p[3]);
        const Mask either =
            hn::AndNot(isExact(p[0]),
                       hn::And(isKnown(p[0]), hn::And(hn::Le(range.low, zero), hn::Ge(range.high, zero))));
        if (hn::AllFalse(Doubles(), either)) return hull;
        const Sign sign = signOf(either, p[0], lane);
        return chooseNumber(sign.read, chooseNumber(sign.above, p[3], p[1]), hull);
    }

    SideLanes* sides_;
    std::uint32_t jump_ = CaseLanes::notNumbered;  ///< of the instruction at hand
    bool isFirst_ = true;      ///< of the instruction at hand: the first one with its jump
    bool wide_ = false;        ///< whether some lane is read further than the grain from its start
    SideLanes::Lanes passed_;  ///< jumps between the start and the reading
};

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
