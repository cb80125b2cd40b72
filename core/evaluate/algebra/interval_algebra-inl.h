// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. The operations of a function graph on vectors of intervals. What has no
// vector code here goes through core/numeric/interval.h lane by lane.
#if defined(ISOSCOPE_EVALUATE_INTERVAL_ALGEBRA_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_INTERVAL_ALGEBRA_INL
#undef ISOSCOPE_EVALUATE_INTERVAL_ALGEBRA_INL
#else
#define ISOSCOPE_EVALUATE_INTERVAL_ALGEBRA_INL
#endif

#include <hwy/highway.h>

#include <array>
#include <limits>
#include <numbers>

#include "core/evaluate/algebra/interval_number-inl.h"
#include "core/evaluate/interval_evaluator.h"
#include "core/evaluate/tape/tape_workspace.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// More than the vector functions and the standard library are off by, relative and (for sine and cosine,
/// up to largestAngle) absolute.
constexpr double elementaryError = 1e-15;

class IntervalAlgebra {
  public:
    using Number = IntervalNumber;
    using Uniform = IntervalUniform;
    static constexpr std::size_t components = 3;
    /// Whether pairs of sums and products are run as one.
    static constexpr bool fuses = false;

    void begin(TapeWorkspace& workspace, std::size_t number) { sides_ = workspace.choiceSides(number); }

    static HWY_INLINE Number load(const double* lanes) {
        const Doubles d;
        return {hn::LoadU(d, lanes), hn::LoadU(d, lanes + batchLanes), hn::LoadU(d, lanes + 2 * batchLanes)};
    }
    static HWY_INLINE void store(const Number& p, double* lanes) {
        const Doubles d;
        hn::Store(p.high, d, lanes);
        hn::Store(p.minusLow, d, lanes + batchLanes);
        hn::Store(p.doubt, d, lanes + 2 * batchLanes);
    }
    static HWY_INLINE Uniform uniform(double value) { return {constantVector(value)}; }
    static HWY_INLINE Number widen(Uniform c) { return c; }
    static HWY_INLINE Number choose(Mask first, const Number& p, const Number& q) {
        return chooseInterval(first, p, q);
    }
    static HWY_INLINE bool isExactLane(const double* lane) {
        return lane[0] == -lane[batchLanes] && lane[2 * batchLanes] == 0;
    }
    static HWY_INLINE Number increment(const Number& p) { return sumOf(p, uniform(1)); }

    HWY_INLINE Number negate(const Number& p) const { return negated(p); }
    HWY_INLINE Number absolute(const Number& p) const {
        const Mask empty = isEmpty(p);
        const Mask positive = hn::Le(p.minusLow, hn::Zero(Doubles()));
        const Mask negative = hn::Le(p.high, hn::Zero(Doubles()));
        record(hn::Or(empty, positive), hn::Or(empty, negative));
        return absoluteOf(p);
    }
    HWY_INLINE Number square(const Number& p) const { return squareOf(p); }
    HWY_INLINE Number squareRoot(const Number& p) const { return squareRootOf(p); }
    HWY_INLINE Number floor(const Number& p) const {
        return {PointAlgebra::floor(p.high), hn::Neg(PointAlgebra::floor(lowOf(p))), p.doubt};
    }
    HWY_INLINE Number ceiling(const Number& p) const {
        return {PointAlgebra::ceiling(p.high), hn::Neg(PointAlgebra::ceiling(lowOf(p))), p.doubt};
    }

    // clang-format off
    HWY_INLINE Number exponential(const Number& p) const {
        Number result = rising(p, [](Vector v) HWY_ATTR { return HWY_NAMESPACE::exponential(v); });
        result.minusLow = hn::Min(result.minusLow, hn::Zero(Doubles()));
        return result;
    }
    HWY_INLINE Number naturalLogarithm(const Number& p) const {
        return rising(restricted(p, 0, endless), [](Vector v) HWY_ATTR { return HWY_NAMESPACE::naturalLogarithm(v); });
    }
    HWY_INLINE Number decimalLogarithm(const Number& p) const {
        return rising(restricted(p, 0, endless), [](Vector v) HWY_ATTR { return HWY_NAMESPACE::decimalLogarithm(v); });
    }
    HWY_INLINE Number arcSine(const Number& p) const {
        return rising(restricted(p, -1, 1), [](Vector v) HWY_ATTR { return HWY_NAMESPACE::arcSine(v); });
    }
    HWY_INLINE Number arcCosine(const Number& p) const {
        return negated(rising(restricted(p, -1, 1), [](Vector v) HWY_ATTR { return hn::Neg(HWY_NAMESPACE::arcCosine(v)); }));
    }
    HWY_INLINE Number arcTangent(const Number& p) const {
        return rising(p, [](Vector v) HWY_ATTR { return HWY_NAMESPACE::arcTangent(v); });
    }
    HWY_INLINE Number hyperbolicSine(const Number& p) const {
        return rising(p, [](Vector v) HWY_ATTR { return HWY_NAMESPACE::hyperbolicSine(v); });
    }
    HWY_INLINE Number hyperbolicCosine(const Number& p) const {
        Number result = rising(absoluteOf(p), [](Vector v) HWY_ATTR { return HWY_NAMESPACE::hyperbolicCosine(v); });
        result.minusLow = hn::Min(result.minusLow, constantVector(-1));
        return result;
    }
    HWY_INLINE Number hyperbolicTangent(const Number& p) const {
        Number result = rising(p, [](Vector v) HWY_ATTR { return HWY_NAMESPACE::hyperbolicTangent(v); });
        result.minusLow = hn::Min(result.minusLow, constantVector(1));
        result.high = hn::Min(result.high, constantVector(1));
        return result;
    }
    HWY_INLINE Number areaSine(const Number& p) const {
        return rising(p, [](Vector v) HWY_ATTR { return HWY_NAMESPACE::areaSine(v); });
    }
    HWY_INLINE Number areaCosine(const Number& p) const {
        return rising(restricted(p, 1, endless), [](Vector v) HWY_ATTR { return HWY_NAMESPACE::areaCosine(v); });
    }
    HWY_INLINE Number areaTangent(const Number& p) const {
        return rising(restricted(p, -1, 1), [](Vector v) HWY_ATTR { return HWY_NAMESPACE::areaTangent(v); });
    }
    HWY_INLINE Number sine(const Number& p) const {
        return wave(p, 0.25, [](Vector v) HWY_ATTR { return HWY_NAMESPACE::sine(v); });
    }
    HWY_INLINE Number cosine(const Number& p) const {
        return wave(p, 0, [](Vector v) HWY_ATTR { return HWY_NAMESPACE::cosine(v); });
    }
    // clang-format on
    Number tangent(const Number& p) const { return laneByLane(Operation::tangent, p, p); }
    Number truncate(const Number& p) const { return laneByLane(Operation::truncate, p, p); }
    Number fraction(const Number& p) const { return laneByLane(Operation::fraction, p, p); }
    Number triangleWave(const Number& p) const { return laneByLane(Operation::triangleWave, p, p); }
    Number cycle(const Number& p) const { return laneByLane(Operation::cycle, p, p); }

    HWY_INLINE Number add(const Number& p, const Number& q) const { return sumOf(p, q); }
    HWY_INLINE Number subtract(const Number& p, const Number& q) const { return sumOf(p, negated(q)); }
    HWY_INLINE Number multiply(const Number& p, const Number& q) const { return productOf(p, q); }
    HWY_INLINE Number divide(const Number& p, const Number& q) const { return quotientOf(p, q); }

    HWY_INLINE Number minimum(const Number& p, const Number& q) const {
        // a <= b ? a : b is b where a side has no value.
        const Mask nowhere = hn::Or(isEmpty(p), isEmpty(q));
        const Mask sure = hn::And(isSure(p), isSure(q));
        const Mask first = hn::AndNot(nowhere, hn::And(sure, hn::Le(p.high, lowOf(q))));
        record(first, hn::Or(nowhere, hn::Gt(lowOf(p), q.high)));
        const Number lesser{hn::Min(p.high, q.high), hn::Max(p.minusLow, q.minusLow), q.doubt};
        return chooseInterval(nowhere, q, chooseInterval(isSure(p), lesser, hullOf(lesser, q)));
    }
    HWY_INLINE Number maximum(const Number& p, const Number& q) const {
        // a < b ? b : a is a where a side has no value.
        const Mask nowhere = hn::Or(isEmpty(p), isEmpty(q));
        const Mask sure = hn::And(isSure(p), isSure(q));
        const Mask second = hn::AndNot(nowhere, hn::And(sure, hn::Lt(p.high, lowOf(q))));
        record(hn::Or(nowhere, hn::Ge(lowOf(p), q.high)), second);
        const Number greater{hn::Max(p.high, q.high), hn::Min(p.minusLow, q.minusLow), p.doubt};
        return chooseInterval(nowhere, p, chooseInterval(isSure(q), greater, hullOf(greater, p)));
    }

#define ISOSCOPE_LANE_BY_LANE(operation)                       \
    Number operation(const Number& p, const Number& q) const { \
        return laneByLane(Operation::operation, p, q);         \
    }
    ISOSCOPE_LANE_BY_LANE(power)
    ISOSCOPE_LANE_BY_LANE(arcTangent2)
    ISOSCOPE_LANE_BY_LANE(remainder)
    ISOSCOPE_LANE_BY_LANE(integerDivide)
    ISOSCOPE_LANE_BY_LANE(equal)
    ISOSCOPE_LANE_BY_LANE(notEqual)
    ISOSCOPE_LANE_BY_LANE(less)
    ISOSCOPE_LANE_BY_LANE(lessEqual)
    ISOSCOPE_LANE_BY_LANE(greater)
    ISOSCOPE_LANE_BY_LANE(greaterEqual)
    ISOSCOPE_LANE_BY_LANE(logicalAnd)
    ISOSCOPE_LANE_BY_LANE(logicalOr)
#undef ISOSCOPE_LANE_BY_LANE

    HWY_INLINE Number select3(const Number& p, const Number& negative, const Number& otherwise) const {
        const Vector zero = hn::Zero(Doubles());
        const Mask above = hn::Or(isEmpty(p), hn::Ge(lowOf(p), zero));
        const Mask below = hn::And(isSure(p), hn::Lt(p.high, zero));
        record(hn::AndNot(above, below), above);
        return chooseInterval(above, otherwise, chooseInterval(below, negative, hullOf(negative, otherwise)));
    }
    HWY_INLINE Number select4(const Number& p, const Number& negative, const Number& zero,
                              const Number& positive) const {
        const Vector origin = hn::Zero(Doubles());
        const Mask above = hn::Or(isEmpty(p), hn::Gt(lowOf(p), origin));
        const Mask below = hn::AndNot(above, hn::And(isSure(p), hn::Lt(p.high, origin)));
        const Mask at = hn::And(isSure(p), hn::And(hn::Eq(p.high, origin), hn::Eq(p.minusLow, origin)));
        record(below, above);
        const Number any = hullOf(negative, hullOf(zero, positive));
        return chooseInterval(above, positive,
                              chooseInterval(below, negative, chooseInterval(at, zero, any)));
    }

    /// Noise and crackle.
    void scalarOperation(const Instruction& instruction, const CrackleSettings* crackle,
                         const std::array<const double*, 4>& operands, double* target,
                         std::size_t lanes) const {
        std::array<Interval, 4> values;
        keepInPlace(target);
        {
            const NearestRounding nearest;
            for (std::size_t i = 0; i < lanes; ++i) {
                for (std::size_t k = 0; k < instruction.operandCount; ++k)
                    values[k] = intervalAt(operands[k] + i);
                writeInterval(evaluateOperation(instruction.operation,
                                                std::span(values).first(instruction.operandCount), crackle),
                              target + i);
            }
            keepInPlace(target);
        }
    }

  private:
    static Interval intervalAt(const double* lane) {
        return {-lane[batchLanes], lane[0], lane[2 * batchLanes] != 0};
    }
    static void writeInterval(const Interval& value, double* lane) {
        lane[0] = value.empty() ? -endless : value.high;
        lane[batchLanes] = value.empty() ? -endless : -value.low;
        lane[2 * batchLanes] = value.maybeUndefined || value.empty();
    }

    /// Which sides a choice may take in some lane; both `first` and `second` where it makes no difference.
    HWY_INLINE void record(Mask first, Mask second) const {
        const Doubles d;
        if (!hn::AllTrue(d, second)) *sides_ |= 1;
        if (!hn::AllTrue(d, first)) *sides_ |= 2;
    }

    /// A function that never falls.
    template <class Function>
    HWY_INLINE Number rising(const Number& p, Function function) const {
        Vector high = p.high, low = lowOf(p);
        atNearest(high, low, [function](Vector& a, Vector& b) HWY_ATTR {
            a = function(a);
            b = function(b);
        });
        const Vector tiny = constantVector(smallestNormal), relative = constantVector(elementaryError);
        const Number result{hn::Add(high, hn::MulAdd(hn::Abs(high), relative, tiny)),
                            hn::Add(hn::Neg(low), hn::MulAdd(hn::Abs(low), relative, tiny)), p.doubt};
        if (HWY_LIKELY(hn::AllTrue(Doubles(), hn::And(isBounded(result), isBounded(p))))) return result;
        return repaired(isEmpty(p), result);
    }

    /// A wave of period 2 pi with its crest at `crest` periods.
    template <class Function>
    HWY_INLINE Number wave(const Number& p, double crest, Function function) const {
        const Vector one = constantVector(1);
        Vector high = p.high, low = lowOf(p);
        const Mask usable = hn::And(isBounded(p), hn::And(within(high, 25000), within(low, 25000)));
        high = hn::IfThenElseZero(usable, high);
        low = hn::IfThenElseZero(usable, low);
        const Mask top = hasWhole(low, high, crest), bottom = hasWhole(low, high, crest + 0.5);
        atNearest(high, low, [function](Vector& a, Vector& b) HWY_ATTR {
            a = function(a);
            b = function(b);
        });
        const Vector error = constantVector(2 * elementaryError);
        const Vector crestValue = hn::Min(one, hn::Add(hn::Max(high, low), error));
        const Vector troughValue = hn::Min(one, hn::Sub(error, hn::Min(high, low)));
        const Number result{hn::IfThenElse(top, one, crestValue), hn::IfThenElse(bottom, one, troughValue),
                            p.doubt};
        // Infinity, which all numbers beyond the largest become, has none.
        const Vector largest = constantVector(std::numeric_limits<double>::max());
        const Mask beyond = hn::Or(hn::Ge(lowOf(p), largest), hn::Ge(hn::Neg(p.high), largest));
        const Number all{one, one, hn::IfThenElse(beyond, inDoubt(), p.doubt)};
        return chooseInterval(usable, result, chooseInterval(isEmpty(p), p, all));
    }
    /// Whether some `offset` + k periods may lie between both.
    static HWY_INLINE Mask hasWhole(Vector low, Vector high, double offset) {
        const Vector turn = constantVector(0.5 * std::numbers::inv_pi), slack = constantVector(1e-10);
        const Vector first = hn::Sub(hn::Sub(hn::Mul(low, turn), constantVector(offset)), slack);
        const Vector last = hn::Add(hn::Sub(hn::Mul(high, turn), constantVector(offset)), slack);
        return hn::Ge(hn::Floor(last), hn::Ceil(first));
    }

    static HWY_NOINLINE Number laneByLane(Operation operation, const Number& p, const Number& q) {
        const Doubles d;
        constexpr std::size_t count = HWY_MAX_BYTES / sizeof(double);
        HWY_ALIGN double a[3 * batchLanes], b[3 * batchLanes];
        store(p, a);
        store(q, b);
        const std::size_t operands = arity(operation) == 1 ? 1 : 2;
        keepInPlace(a);
        keepInPlace(b);
        {
            const NearestRounding nearest;
            for (std::size_t i = 0; i < count && i < hn::Lanes(d); ++i) {
                const std::array<Interval, 2> values{intervalAt(a + i), intervalAt(b + i)};
                writeInterval(evaluateOperation(operation, std::span(values).first(operands)), a + i);
            }
            keepInPlace(a);
        }
        keepInPlace(a);
        return load(a);
    }

    std::uint8_t* sides_ = nullptr;
};

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
