// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. Affine forms that keep the sides of jumps apart (CaseLanes).
#if defined(ISOSCOPE_EVALUATE_AFFINE_CASES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_AFFINE_CASES_INL
#undef ISOSCOPE_EVALUATE_AFFINE_CASES_INL
#else
#define ISOSCOPE_EVALUATE_AFFINE_CASES_INL
#endif

#include <hwy/highway.h>

#include <array>
#include <limits>
#include <numbers>

#include "core/evaluate/jumps/affine_cases.h"
#include "core/evaluate/jumps/affine_whole-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// The rules of AffineAlgebra for operations that jump, but that these tell where they do, and take the side
/// that lanes are told; and of sums, products and quotients, but that whole numbers remain exact.
class AffineCaseAlgebra : public AffineWholeAlgebra {
  public:
    explicit AffineCaseAlgebra(CaseLanes& cases) : cases_(&cases) {}

    /// Before instruction `number` of the workspace's tape, as for AffineAlgebra.
    void begin(const TapeWorkspace& workspace, std::size_t number) {
        AffineWholeAlgebra::begin(workspace, number);
        jump_ = number < cases_->jumpOf.size() ? cases_->jumpOf[number] : CaseLanes::notNumbered;
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
            case Operation::equal: return equality(equal(p[0], p[1]), p[0], p[1], lane);
            case Operation::notEqual: return equality(notEqual(p[0], p[1]), p[0], p[1], lane);
            case Operation::less: return compared(less(p[0], p[1]), p[1], p[0], lane);
            case Operation::lessEqual: return compared(lessEqual(p[0], p[1]), p[1], p[0], lane);
            case Operation::greater: return compared(greater(p[0], p[1]), p[0], p[1], lane);
            case Operation::greaterEqual: return compared(greaterEqual(p[0], p[1]), p[0], p[1], lane);
            case Operation::logicalAnd: return truth(logicalAnd(p[0], p[1]), lane);
            case Operation::logicalOr: return truth(logicalOr(p[0], p[1]), lane);
            case Operation::select3: return chosen(select3(p[0], p[1], p[2]), p[0], p[1], p[2], lane);
            default: return chosenOfThree(p, lane);
        }
    }

  private:
    /// The sides that lanes are told of the jump at hand.
    struct Told {
        Vector side;
        Mask known;
    };
    HWY_INLINE Told told(std::size_t lane) const {
        const Vector side = hn::LoadU(Doubles(), &cases_->sides[jump_][lane]);
        return {side, hn::Eq(side, side)};
    }

    /// Notes that the jump at hand is open in the lanes of `where`, between two sides or, for a `higher` that
    /// is not a number, more: where `operand` passes `value`, upward from the lower to the higher.
    HWY_INLINE void note(Mask where, const Number& operand, Vector value, Vector lower, Vector higher,
                         std::size_t lane, bool ordered = true) {
        const Doubles d;
        if (hn::AllFalse(d, where)) return;
        const Place place = placeOf(operand, value);
        const Vector zero = zeroVector();
        const Mask first = hn::And(where, hn::Lt(hn::LoadU(d, &cases_->jump[lane]), zero));
        const auto put = [&](Mask lanes, Vector number, CaseLanes::Lanes& to) HWY_ATTR {
            hn::StoreU(hn::IfThenElse(lanes, number, hn::LoadU(d, &to[lane])), d, &to[lane]);
        };
        put(first, constantVector(jump_), cases_->jump);
        put(first, lower, cases_->lower);
        put(first, higher, cases_->higher);
        put(first, place.low, cases_->low);
        put(first, place.high, cases_->high);
        const Vector direction = hn::CopySign(constantVector(ordered ? 1 : 0), operand.b);
        put(first, hn::IfThenElseZero(place.known, direction), cases_->rises);
        const Mask sooner =
            hn::And(hn::And(where, place.known), hn::Lt(place.low, hn::LoadU(d, &cases_->firstLow[lane])));
        put(sooner, place.low, cases_->firstLow);
        put(sooner, place.high, cases_->firstHigh);
    }

    /// The places s of a piece where an operand may be the value, give or take its error in parts of its
    /// slope. Without much of a slope they may be anywhere, or the jump is one with another that the operand
    /// has passed: nothing is known.
    struct Place {
        Vector low, high;
        Mask known;
    };
    static HWY_INLINE Place placeOf(const Number& operand, Vector value) {
        const Vector one = constantVector(1);
        const Vector rounding =
            hn::Mul(hn::Add(hn::Abs(value), hn::Abs(operand.a)), constantVector(4 * roundingUnit));
        const Vector reach = hn::Add(operand.e, rounding), slope = hn::Abs(operand.b);
        const Vector middle = hn::Div(hn::Sub(value, operand.a), operand.b);
        const Vector width = hn::Add(hn::Div(reach, slope), constantVector(16 * roundingUnit));
        const Mask known = hn::Gt(slope, reach);
        const auto placed = [&](Vector s) HWY_ATTR {
            return hn::IfThenElse(hn::Lt(hn::Abs(s), one), s, hn::CopySign(one, s));
        };
        return {hn::IfThenElse(known, placed(hn::Sub(middle, width)), hn::Neg(one)),
                hn::IfThenElse(known, placed(hn::Add(middle, width)), one), known};
    }

    /// The step of a staircase, if lanes are told it; else notes the jump between the steps `first` and
    /// `last`, at `up` first if the operand rises, else at `down`.
    HWY_INLINE Told stepOf(const Number& p, Vector first, Vector last, Vector up, Vector down,
                           std::size_t lane) {
        const Told step = told(lane);
        const Mask jumps = hn::AndNot(step.known, hn::And(isKnown(p), hn::Lt(first, last)));
        const Mask two = hn::Le(hn::Sub(last, first), constantVector(1));
        const Vector next = hn::IfThenElse(hn::Gt(p.b, zeroVector()), up, down);
        note(jumps, p, next, first, hn::IfThenElse(two, last, constantVector(nothing)), lane);
        return step;
    }
    HWY_INLINE Number floorOf(const Number& p, std::size_t lane) {
        const VectorRange range = tight(p, clippedRange(p, domain(0)));
        const Vector first = hn::Floor(range.low), last = hn::Floor(range.high);
        const Told step = stepOf(p, first, last, hn::Add(first, constantVector(1)), last, lane);
        return chooseNumber(isExact(p), exactNumber(hn::Floor(p.a)),
                            chooseNumber(step.known, exactNumber(step.side), floor(p)));
    }
    HWY_INLINE Number fractionOf(const Number& p, std::size_t lane) {
        const VectorRange range = tight(p, rangeOf(p));
        const Vector first = hn::Floor(range.low), last = hn::Floor(range.high);
        const Told step = stepOf(p, first, last, hn::Add(first, constantVector(1)), last, lane);
        const Number told = exactSum(p, exactNumber(hn::Neg(step.side)));
        const Number exact = exactSum(p, exactNumber(hn::Neg(first)));
        return chooseNumber(isExact(p), exact, chooseNumber(step.known, told, fraction(p)));
    }
    HWY_INLINE Number ceilingOf(const Number& p, std::size_t lane) {
        const VectorRange range = tight(p, clippedRange(p, domain(0)));
        const Vector first = hn::Ceil(range.low), last = hn::Ceil(range.high);
        const Told step = stepOf(p, first, last, first, hn::Sub(last, constantVector(1)), lane);
        return chooseNumber(isExact(p), exactNumber(hn::Ceil(p.a)),
                            chooseNumber(step.known, exactNumber(step.side), ceiling(p)));
    }
    /// Toward zero: as floor above 0, as ceiling below.
    HWY_INLINE Told truncationOf(const Number& p, std::size_t lane) {
        const VectorRange range = tight(p, rangeOf(p));
        const Vector first = hn::Trunc(range.low), last = hn::Trunc(range.high);
        const Vector one = constantVector(1), zero = zeroVector();
        const Vector up = hn::IfThenElse(hn::Lt(first, zero), first, hn::Add(first, one));
        const Vector down = hn::IfThenElse(hn::Gt(last, zero), last, hn::Sub(last, one));
        return stepOf(p, first, last, up, down, lane);
    }
    /// What lanes are told, or, of an exact operand, its own step toward zero.
    static HWY_INLINE Told certainOr(const Told& step, const Number& p) {
        const Mask exact = isExact(p);
        return {hn::IfThenElse(exact, hn::Trunc(p.a), step.side), hn::Or(exact, step.known)};
    }
    HWY_INLINE Number truncated(const Number& p, std::size_t lane) {
        const Told step = certainOr(truncationOf(p, lane), p);
        // Beyond 32 bits the value is another one.
        const Mask fits = hn::Lt(hn::Abs(step.side), constantVector(2147483647.0));
        return chooseNumber(hn::And(step.known, fits), exactNumber(step.side), truncate(p));
    }
    HWY_INLINE Number remainderOf(const Number& p, const Number& q, std::size_t lane) {
        const Number quotient = stepQuotient(p, q);
        const Told step = certainOr(truncationOf(quotient, lane), quotient);
        const Number side = stepRest(p, q, step.side);
        return chooseNumber(step.known, side, AffineAlgebra::remainderOf(p, q, quotient));
    }

    /// On the cut, seen from the other side: the angle of the opposite point and half a turn.
    HWY_INLINE Number angle(const Number& ordinate, const Number& abscissa, std::size_t lane) {
        const Told side = told(lane);
        const VectorRange y = rangeOf(ordinate), x = rangeOf(abscissa);
        const Vector zero = zeroVector(), one = constantVector(1);
        const Mask known = hn::And(isKnown(ordinate), isKnown(abscissa));
        const Mask cut =
            hn::And(hn::And(known, hn::Lt(x.high, zero)), hn::And(hn::Le(y.low, zero), hn::Ge(y.high, zero)));
        if (hn::AllFalse(Doubles(), hn::Or(cut, side.known))) return arcTangent2(ordinate, abscissa);
        note(hn::AndNot(side.known, cut), ordinate, zero, zero, one, lane);
        const Vector pi = constantVector(std::numbers::pi);
        const Vector halfTurn = hn::IfThenElse(hn::Gt(side.side, zero), pi, hn::Neg(pi));
        const Number angle = arcTangent2(chooseNumber(side.known, negated(ordinate), ordinate),
                                         chooseNumber(side.known, negated(abscissa), abscissa));
        const Number turned = sumOf(angle, Number{halfTurn, zero, constantVector(2 * roundingUnit)});
        return chooseNumber(side.known, turned, angle);
    }

    /// 1 where p is above q, 0 below, where it is open.
    HWY_INLINE Number compared(const Number& hull, const Number& p, const Number& q, std::size_t lane,
                               bool ordered = true) {
        const Told side = told(lane);
        const Mask known = hn::Or(isExact(hull), side.known);
        const Mask open = hn::AndNot(known, hn::And(isKnown(p), isKnown(q)));
        note(open, differenceOf(p, q), zeroVector(), zeroVector(), constantVector(1), lane, ordered);
        return chooseNumber(side.known, exactNumber(side.side), hull);
    }
    HWY_INLINE Number equality(const Number& hull, const Number& p, const Number& q, std::size_t lane) {
        return compared(hull, p, q, lane, false);
    }
    HWY_INLINE Number truth(const Number& hull, std::size_t lane) {
        const Told side = told(lane);
        const Mask open = hn::AndNot(hn::Or(isExact(hull), side.known), isKnown(hull));
        note(open, hull, hull.a, zeroVector(), constantVector(1), lane, false);
        return chooseNumber(side.known, exactNumber(side.side), hull);
    }

    HWY_INLINE Number chosen(const Number& hull, const Number& p, const Number& negative,
                             const Number& otherwise, std::size_t lane) {
        const Told side = told(lane);
        const VectorRange range = rangeOf(p);
        const Vector zero = zeroVector();
        const Mask either = hn::And(isKnown(p), hn::And(hn::Lt(range.low, zero), hn::Ge(range.high, zero)));
        note(hn::AndNot(side.known, either), p, zero, zero, constantVector(1), lane);
        const Number taken = chooseNumber(hn::Gt(side.side, zero), otherwise, negative);
        return chooseNumber(side.known, taken, hull);
    }
    /// The value at 0 goes with the side that it equals, else with the higher one.
    HWY_INLINE Number chosenOfThree(const std::array<Number, 4>& p, std::size_t lane) {
        const Told side = told(lane);
        const VectorRange range = rangeOf(p[0]);
        const Vector zero = zeroVector();
        const Number hull = select4(p[0], p[1], p[2], p[3]);
        const Mask either =
            hn::And(isKnown(p[0]), hn::And(hn::Le(range.low, zero), hn::Ge(range.high, zero)));
        note(hn::AndNot(side.known, either), p[0], zero, zero, constantVector(1), lane);
        const Mask joined = hn::Or(same(p[2], p[1]), same(p[2], p[3]));
        const Number high = chooseNumber(joined, p[3], hullOf(p[2], p[3]));
        const Number taken = chooseNumber(hn::Gt(side.side, zero), high, p[1]);
        return chooseNumber(side.known, taken, hull);
    }
    static HWY_INLINE Mask same(const Number& p, const Number& q) {
        return hn::And(hn::Eq(p.a, q.a), hn::And(hn::Eq(p.b, q.b), hn::Eq(p.e, q.e)));
    }

    static constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

    CaseLanes* cases_;
    std::uint32_t jump_ = CaseLanes::notNumbered;  ///< of the instruction at hand
};

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
