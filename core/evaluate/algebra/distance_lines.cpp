// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/algebra/distance_lines.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/evaluate/algebra/distance_lines.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::CappedTag<double, 8>;
using Vector = hn::Vec<Doubles>;
using Mask = hn::Mask<Doubles>;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double roundings = DistanceLines::roundings;

HWY_INLINE Vector all(double value) { return hn::Set(Doubles(), value); }

HWY_INLINE Vector squareSum(Vector x, Vector y, Vector z) {
    return hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
}

/// The lanes from `first` on that are less than `count`.
HWY_INLINE Mask lanesBelow(std::size_t first, std::size_t count) {
    return hn::FirstN(Doubles(), count > first ? count - first : 0);
}

/// The least three numbers of all lanes.
class LeastLanes {
  public:
    HWY_INLINE LeastLanes() {
        for (Vector& vector : least_) vector = all(infinite);
    }
    HWY_INLINE void add(Vector number) {
        const Vector second = hn::Max(least_[0], number), third = hn::Max(least_[1], second);
        least_[0] = hn::Min(least_[0], number);
        least_[1] = hn::Min(least_[1], second);
        least_[2] = hn::Min(least_[2], third);
    }
    /// Takes the least one out.
    HWY_INLINE double take() {
        const Vector least = hn::MinOfLanes(Doubles(), least_[0]);
        const intptr_t lane = hn::FindFirstTrue(Doubles(), hn::Eq(least_[0], least));
        const Mask taken =
            hn::And(hn::Eq(least_[0], least), lanesBelow(0, static_cast<std::size_t>(lane) + 1));
        least_[0] = hn::IfThenElse(taken, least_[1], least_[0]);
        least_[1] = hn::IfThenElse(taken, least_[2], least_[1]);
        return hn::GetLane(least);
    }

  private:
    Vector least_[3];
};

/// sqrt(|p - point|^2 + offset^2) and its tangent in the middle: d'' is all that makes it rise above.
HWY_INLINE void writeLines(const LinePiece& piece, Vector square, Vector along, double offset, double* slopes,
                           double* lows, double* highs) {
    const Vector middle = hn::Sqrt(hn::Add(square, all(offset * offset)));
    const Vector length = all(piece.length), zero = hn::Zero(Doubles());
    const Vector rounding = hn::Add(hn::Mul(all(roundings), hn::Add(middle, length)), all(piece.spread));
    const Mask isFar = hn::Gt(middle, all(1.001 * piece.length));
    const Vector slope = hn::IfThenElseZero(isFar, hn::Div(along, middle));
    // d^2 - tangent^2 = (length^2 - slope^2) s^2, and neither is less than middle - |slope|.
    const Vector room = hn::Mul(all(2), hn::Sub(middle, hn::Abs(slope)));
    Vector bend = hn::Div(hn::Sub(all(piece.length * piece.length), hn::Mul(slope, slope)), room);
    bend = hn::Min(bend, hn::Mul(all(2), length));
    const Vector fall = hn::IfThenElse(isFar, zero, hn::Min(middle, length));
    const Vector rise = hn::IfThenElse(isFar, bend, length);
    hn::Store(slope, Doubles(), slopes);
    hn::Store(hn::Sub(middle, hn::Add(fall, rounding)), Doubles(), lows);
    hn::Store(hn::Add(middle, hn::Add(rise, rounding)), Doubles(), highs);
}

void writeEuclidean(const LinePiece& piece, const CrackleCandidates& found, double offset, std::size_t order,
                    DistanceLines& lines) {
    const std::size_t step = hn::Lanes(Doubles());
    alignas(64) std::array<double, CrackleCandidates::most> squares, along;
    LeastLanes leastLanes;
    const auto apart =
        [&](const std::array<double, CrackleCandidates::most>& column, std::size_t axis, std::size_t i)
            HWY_ATTR { return hn::Sub(all(piece.center[axis]), hn::LoadU(Doubles(), &column[i])); };
    for (std::size_t i = 0; i < found.count; i += step) {
        const Vector x = apart(found.x, 0, i), y = apart(found.y, 1, i), z = apart(found.z, 2, i);
        const Vector square = squareSum(x, y, z);
        hn::Store(square, Doubles(), &squares[i]);
        leastLanes.add(hn::IfThenElse(lanesBelow(i, found.always), square, all(infinite)));
        const Vector xy = hn::Add(hn::Mul(x, all(piece.slope[0])), hn::Mul(y, all(piece.slope[1])));
        hn::Store(hn::Add(xy, hn::Mul(z, all(piece.slope[2]))), Doubles(), &along[i]);
    }
    double nearest = 0;
    for (std::size_t k = 0; k < order; ++k) {
        nearest = leastLanes.take();
        lines.nearest[k] = static_cast<std::size_t>(std::ranges::find(squares, nearest) - squares.begin());
    }
    // Distances change by no more than the piece is long.
    const double furthest = (std::sqrt(nearest) + 2 * (piece.length + piece.spread)) * (1 + roundings);
    const Vector limit = all(furthest * furthest);
    lines.count = found.count;
    for (std::size_t i = 0; i < found.count; i += step) {
        const Vector square = hn::Load(Doubles(), &squares[i]);
        const Mask counts = hn::And(hn::Le(square, limit), lanesBelow(i, found.count));
        double *const low = &lines.low[i], *const high = &lines.high[i];
        if (hn::AllFalse(Doubles(), counts)) {
            hn::Store(hn::Zero(Doubles()), Doubles(), &lines.slope[i]);
            hn::Store(all(infinite), Doubles(), low);
            hn::Store(all(infinite), Doubles(), high);
            continue;
        }
        writeLines(piece, square, hn::Load(Doubles(), &along[i]), offset, &lines.slope[i], low, high);
        const Mask bounds = hn::And(counts, lanesBelow(i, found.always));
        hn::Store(hn::IfThenElse(counts, hn::Load(Doubles(), low), all(infinite)), Doubles(), low);
        hn::Store(hn::IfThenElse(bounds, hn::Load(Doubles(), high), all(infinite)), Doubles(), high);
    }
}

DistanceLine orderedLine(const DistanceLines& lines, std::size_t order) {
    const double slope = lines.slope[lines.nearest[order]];
    LeastLanes lows, highs;
    for (std::size_t i = 0; i < lines.count; i += hn::Lanes(Doubles())) {
        const Mask counts = lanesBelow(i, lines.count);
        const Vector turn = hn::Abs(hn::Sub(hn::Load(Doubles(), &lines.slope[i]), all(slope)));
        const Vector low = hn::Sub(hn::Load(Doubles(), &lines.low[i]), turn);
        const Vector high = hn::Add(hn::Load(Doubles(), &lines.high[i]), turn);
        lows.add(hn::IfThenElse(counts, low, all(infinite)));
        highs.add(hn::IfThenElse(counts, high, all(infinite)));
    }
    DistanceLine line{slope, 0, 0};
    for (std::size_t k = 0; k <= order; ++k) {
        line.low = lows.take();
        line.high = highs.take();
    }
    return line;
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(writeEuclidean);
HWY_EXPORT(orderedLine);

void writeEuclideanLines(const LinePiece& piece, const CrackleCandidates& found, double offset,
                         std::size_t order, DistanceLines& lines) {
    HWY_DYNAMIC_DISPATCH(writeEuclidean)(piece, found, offset, order, lines);
}

DistanceLine orderedDistance(const DistanceLines& lines, std::size_t order) {
    return HWY_DYNAMIC_DISPATCH(orderedLine)(lines, order);
}

}  // namespace isoscope
#endif
