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
#include <numbers>

#include "core/evaluate/algebra/affine_cases.h"
#include "core/evaluate/algebra/affine_algebra-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// The rules of AffineAlgebra for operations that jump, but that these tell where they do, and take one side
/// where lanes ask for it; and of sums, products and quotients, but that whole numbers remain exact.
class AffineCaseAlgebra : public AffineAlgebra {
  public:
    explicit AffineCaseAlgebra(CaseLanes& cases) : cases_(&cases) {}

    /// Before instruction `number` of the workspace's tape, as for AffineAlgebra.
    void begin(const TapeWorkspace& workspace, std::size_t number) {
        AffineAlgebra::begin(workspace, number);
        shared_ = number < cases_->shared.size() ? cases_->shared[number] : CaseLanes::Shared{};
    }

    /// Whether run() has a rule for it.
    static constexpr bool covers(Operation operation) {
        return hasSides(operation) || operation == Operation::add || operation == Operation::subtract ||
               operation == Operation::multiply || operation == Operation::divide;
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
            case Operation::integerDivide: return truncated(divide(p[0], p[1]), lane);
            case Operation::remainder: return remainderOf(p[0], p[1], lane);
            case Operation::arcTangent2: return angle(p[0], p[1], lane);
            case Operation::equal: return compared(equal(p[0], p[1]), p[0], p[1], lane);
            case Operation::notEqual: return compared(notEqual(p[0], p[1]), p[0], p[1], lane);
            case Operation::less: return compared(less(p[0], p[1]), p[0], p[1], lane);
            case Operation::lessEqual: return compared(lessEqual(p[0], p[1]), p[0], p[1], lane);
            case Operation::greater: return compared(greater(p[0], p[1]), p[0], p[1], lane);
            case Operation::greaterEqual: return compared(greaterEqual(p[0], p[1]), p[0], p[1], lane);
            case Operation::logicalAnd: return truth(logicalAnd(p[0], p[1]), lane);
            case Operation::logicalOr: return truth(logicalOr(p[0], p[1]), lane);
            case Operation::select3: return chosen(select3(p[0], p[1], p[2]), p[0], p[1], p[2], lane);
            default: return chosenOfThree(p, lane);
        }
    }

  private:
    /// Without an error where both are exact and their sum is a double: what is a step of a staircase remains
    /// on it. After Knuth's two-sum.
    static HWY_INLINE Number exactSum(const Number& p, const Number& q) {
        const Vector sum = hn::Add(p.a, q.a), part = hn::Sub(sum, p.a);
        const Vector lost = hn::Add(hn::Sub(p.a, hn::Sub(sum, part)), hn::Sub(q.a, part));
        const Mask exact = hn::And(hn::And(isExact(p), isExact(q)), hn::Eq(lost, zeroVector()));
        return chooseNumber(exact, exactNumber(sum), sumOf(p, q));
    }
    static HWY_INLINE Number exactProduct(const Number& p, const Number& q) {
        const Vector product = hn::Mul(p.a, q.a);
        const Mask exact = hn::And(hn::And(isExact(p), isExact(q)), isRemainderless(p.a, q.a, product));
        return chooseNumber(exact, exactNumber(product), productOf(p, q));
    }
    HWY_INLINE Number exactQuotient(const Number& p, const Number& q) const {
        // By one number for a lane: no worse than by a constant.
        const Mask divisible = hn::And(isExact(q), hn::Ne(q.a, zeroVector()));
        const Number byNumber = divide(p, Uniform{q.a});
        const Number quotient =
            hn::AllTrue(Doubles(), divisible) ? byNumber : chooseNumber(divisible, byNumber, divide(p, q));
        const Vector value = hn::Div(p.a, q.a);
        const Mask exact = hn::And(hn::And(isExact(p), divisible), isRemainderless(value, q.a, p.a));
        return chooseNumber(exact, exactNumber(value), quotient);
    }
    /// Whether a b = product in real numbers; false as well where what is lost could get lost itself.
    static HWY_INLINE Mask isRemainderless(Vector a, Vector b, Vector product) {
        const Vector zero = zeroVector(), size = hn::Abs(product);
        const Mask moderate =
            hn::And(hn::Gt(size, constantVector(1e-200)), hn::Lt(size, constantVector(1e200)));
        const Mask nothing = hn::And(hn::Eq(product, zero), hn::Or(hn::Eq(a, zero), hn::Eq(b, zero)));
        return hn::Or(nothing, hn::And(moderate, hn::Eq(lostBy(a, b, product), zero)));
    }
    /// a b - product for their rounded product. After Dekker where there is no fused multiplication.
    static HWY_INLINE Vector lostBy(Vector a, Vector b, Vector product) {
#if HWY_NATIVE_FMA
        return hn::MulSub(a, b, product);
#else
        const auto high = [](Vector v) HWY_ATTR {
            const Vector scaled = hn::Mul(v, constantVector(134217729));
            return hn::Sub(scaled, hn::Sub(scaled, v));
        };
        const Vector highA = high(a), highB = high(b), lowA = hn::Sub(a, highA), lowB = hn::Sub(b, highB);
        const Vector first = hn::Sub(hn::Mul(highA, highB), product);
        const Vector second = hn::Add(hn::Add(first, hn::Mul(highA, lowB)), hn::Mul(lowA, highB));
        return hn::Add(second, hn::Mul(lowA, lowB));
#endif
    }

    /// Notes the jumps of the lanes of `where`, at which `operand` passes `value`, `count` of them in each.
    /// Returns those that are to take the higher side.
    HWY_INLINE Mask note(Mask where, const Number& operand, Vector value, Vector count, std::size_t lane) {
        const Doubles d;
        double* const taken = &cases_->taken[shared_.number][lane];
        if (shared_.number > 0 && !shared_.first) return hn::Gt(hn::LoadU(d, taken), zeroVector());
        const Mask higher = noteFirst(where, operand, value, count, lane);
        if (shared_.number > 0) hn::StoreU(hn::IfThenElseZero(higher, constantVector(1)), d, taken);
        return higher;
    }
    HWY_INLINE Mask noteFirst(Mask where, const Number& operand, Vector value, Vector count,
                              std::size_t lane) {
        const Doubles d;
        if (hn::AllFalse(d, where)) return where;
        const Vector one = constantVector(1);
        const Vector before = hn::LoadU(d, &cases_->jumps[lane]);
        hn::StoreU(hn::Add(before, hn::IfThenElseZero(where, count)), d, &cases_->jumps[lane]);
        // s where the operand is the value, give or take its error in parts of its slope. Without much of a
        // slope the jump may be anywhere, or is one with another that the operand has passed: nothing is
        // told.
        const Vector rounding =
            hn::Mul(hn::Add(hn::Abs(value), hn::Abs(operand.a)), constantVector(4 * roundingUnit));
        const Vector reach = hn::Add(operand.e, rounding), slope = hn::Abs(operand.b);
        const Vector middle = hn::Div(hn::Sub(value, operand.a), operand.b);
        const Vector width = hn::Add(hn::Div(reach, slope), constantVector(16 * roundingUnit));
        const auto placed = [&](Vector s) HWY_ATTR {
            return hn::IfThenElse(hn::Lt(hn::Abs(s), one), s, hn::CopySign(one, s));
        };
        const Vector low = placed(hn::Sub(middle, width)), high = placed(hn::Add(middle, width));
        const Vector first = hn::LoadU(d, &cases_->first[lane]), last = hn::LoadU(d, &cases_->last[lane]);
        const Mask sooner = hn::And(hn::And(where, hn::Gt(slope, reach)), hn::Lt(low, first));
        hn::StoreU(hn::IfThenElse(sooner, low, first), d, &cases_->first[lane]);
        hn::StoreU(hn::IfThenElse(sooner, high, last), d, &cases_->last[lane]);
        const Vector sides = hn::LoadU(d, &cases_->sides[lane]);
        const Vector rest = hn::Floor(hn::Mul(sides, constantVector(0.5)));
        hn::StoreU(hn::IfThenElse(where, rest, sides), d, &cases_->sides[lane]);
        return hn::And(where, hn::Gt(sides, hn::Add(rest, rest)));
    }

    /// `side` in the lanes of `where`, if sides are asked for.
    HWY_INLINE Number take(Mask where, const Number& side, const Number& hull) const {
        return cases_->bySides ? chooseNumber(where, side, hull) : hull;
    }

    /// The step of a staircase that a lane takes, if there are but two: lanes on more keep their hull.
    struct Step {
        Vector value;
        Mask two;
    };
    /// Between the steps `first` and `last` the operand jumps at `up` first if it rises, else at `down`.
    HWY_INLINE Step stepOf(const Number& p, Vector first, Vector last, Vector up, Vector down,
                           std::size_t lane) {
        const Vector one = constantVector(1);
        const Mask jumps = hn::And(isKnown(p), hn::Lt(first, last));
        const Mask two = hn::And(jumps, hn::Le(hn::Sub(last, first), one));
        const Vector next = hn::IfThenElse(hn::Gt(p.b, zeroVector()), up, down);
        const Vector count = hn::IfThenElse(two, one, constantVector(CaseLanes::tooMany));
        const Mask higher = note(jumps, p, next, count, lane);
        return {hn::IfThenElse(higher, last, first), two};
    }
    /// The range of an operand; of an exact one without the rounding of its ends.
    static HWY_INLINE VectorRange tight(const Number& p, const VectorRange& range) {
        const Mask exact = isExact(p);
        return {hn::IfThenElse(exact, p.a, range.low), hn::IfThenElse(exact, p.a, range.high)};
    }
    HWY_INLINE Number floorOf(const Number& p, std::size_t lane) {
        const VectorRange range = tight(p, clippedRange(p, domain(0)));
        const Vector first = hn::Floor(range.low), last = hn::Floor(range.high);
        const Step step = stepOf(p, first, last, hn::Add(first, constantVector(1)), last, lane);
        return chooseNumber(isExact(p), exactNumber(hn::Floor(p.a)),
                            take(step.two, exactNumber(step.value), floor(p)));
    }
    HWY_INLINE Number ceilingOf(const Number& p, std::size_t lane) {
        const VectorRange range = tight(p, clippedRange(p, domain(0)));
        const Vector first = hn::Ceil(range.low), last = hn::Ceil(range.high);
        const Step step = stepOf(p, first, last, first, hn::Sub(last, constantVector(1)), lane);
        return chooseNumber(isExact(p), exactNumber(hn::Ceil(p.a)),
                            take(step.two, exactNumber(step.value), ceiling(p)));
    }
    /// Toward zero: as floor above 0, as ceiling below.
    HWY_INLINE Step truncationOf(const Number& p, std::size_t lane) {
        const VectorRange range = tight(p, rangeOf(p));
        const Vector first = hn::Trunc(range.low), last = hn::Trunc(range.high);
        const Vector one = constantVector(1), zero = zeroVector();
        const Vector up = hn::IfThenElse(hn::Lt(first, zero), first, hn::Add(first, one));
        const Vector down = hn::IfThenElse(hn::Gt(last, zero), last, hn::Sub(last, one));
        return stepOf(p, first, last, up, down, lane);
    }
    HWY_INLINE Number truncated(const Number& p, std::size_t lane) {
        const Step step = truncationOf(p, lane);
        // Beyond 32 bits the value is another one.
        const Mask fits = hn::Lt(hn::Abs(step.value), constantVector(2147483647.0));
        return take(hn::And(step.two, fits), exactNumber(step.value), truncate(p));
    }
    HWY_INLINE Number remainderOf(const Number& p, const Number& q, std::size_t lane) {
        const Step step = truncationOf(divide(p, q), lane);
        const Number side = differenceOf(p, productOf(q, exactNumber(step.value)));
        return take(step.two, side, remainder(p, q));
    }

    /// On the cut, seen from the other side: the angle of the opposite point and half a turn.
    HWY_INLINE Number angle(const Number& ordinate, const Number& abscissa, std::size_t lane) {
        const Number hull = arcTangent2(ordinate, abscissa);
        const VectorRange y = rangeOf(ordinate), x = rangeOf(abscissa);
        const Vector zero = zeroVector();
        const Mask known = hn::And(isKnown(ordinate), isKnown(abscissa));
        const Mask cut =
            hn::And(hn::And(known, hn::Lt(x.high, zero)), hn::And(hn::Le(y.low, zero), hn::Ge(y.high, zero)));
        if (hn::AllFalse(Doubles(), cut)) return hull;
        const Mask higher = note(cut, ordinate, zero, constantVector(1), lane);
        const Vector pi = constantVector(std::numbers::pi);
        const Vector halfTurn = hn::IfThenElse(higher, pi, hn::Neg(pi));
        const Number opposite = arcTangent2(negated(ordinate), negated(abscissa));
        const Number turned = sumOf(opposite, Number{halfTurn, zero, constantVector(2 * roundingUnit)});
        return take(cut, turned, hull);
    }

    /// 1 or 0, where it is open: p against q changes where they meet.
    HWY_INLINE Number compared(const Number& hull, const Number& p, const Number& q, std::size_t lane) {
        const Mask open = hn::AndNot(isExact(hull), hn::And(isKnown(p), isKnown(q)));
        const Mask higher = note(open, differenceOf(p, q), zeroVector(), constantVector(1), lane);
        return take(open, bit(higher), hull);
    }
    HWY_INLINE Number truth(const Number& hull, std::size_t lane) {
        const Mask open = hn::AndNot(isExact(hull), isKnown(hull));
        const Mask higher = note(open, hull, hull.a, constantVector(1), lane);
        return take(open, bit(higher), hull);
    }
    static HWY_INLINE Number bit(Mask set) { return exactNumber(hn::IfThenElseZero(set, constantVector(1))); }

    HWY_INLINE Mask open(const Number& p) const {
        const VectorRange range = rangeOf(p);
        return hn::And(isKnown(p),
                       hn::And(hn::Lt(range.low, zeroVector()), hn::Ge(range.high, zeroVector())));
    }
    HWY_INLINE Number chosen(const Number& hull, const Number& p, const Number& negative,
                             const Number& otherwise, std::size_t lane) {
        const Mask either = open(p);
        const Mask higher = note(either, p, zeroVector(), constantVector(1), lane);
        return take(either, chooseNumber(higher, otherwise, negative), hull);
    }
    /// The value at 0 goes with the side that it equals, else with the higher one.
    HWY_INLINE Number chosenOfThree(const std::array<Number, 4>& p, std::size_t lane) {
        const VectorRange range = rangeOf(p[0]);
        const Number hull = select4(p[0], p[1], p[2], p[3]);
        const Mask either = hn::And(
            isKnown(p[0]), hn::And(hn::Le(range.low, zeroVector()), hn::Ge(range.high, zeroVector())));
        const Mask higher = note(either, p[0], zeroVector(), constantVector(1), lane);
        const Mask joined = hn::Or(same(p[2], p[1]), same(p[2], p[3]));
        const Number high = chooseNumber(joined, p[3], hullOf(p[2], p[3]));
        return take(either, chooseNumber(higher, high, p[1]), hull);
    }
    static HWY_INLINE Mask same(const Number& p, const Number& q) {
        return hn::And(hn::Eq(p.a, q.a), hn::And(hn::Eq(p.b, q.b), hn::Eq(p.e, q.e)));
    }

    CaseLanes* cases_;
    CaseLanes::Shared shared_;  ///< of the instruction at hand
};

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
