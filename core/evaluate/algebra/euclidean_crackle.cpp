// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/algebra/euclidean_crackle.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/evaluate/algebra/euclidean_crackle.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/numeric/crackle.h"
#include "core/numeric/crackle_candidates.h"
#include "core/numeric/noise.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::CappedTag<double, 8>;
using Vector = hn::Vec<Doubles>;
using Mask = hn::Mask<Doubles>;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double roundings = crackleRoundings;

HWY_INLINE Vector all(double value) { return hn::Set(Doubles(), value); }

HWY_INLINE Vector scalarProduct(const Vector* p, const Vector* q) {
    return hn::Add(hn::Add(hn::Mul(p[0], q[0]), hn::Mul(p[1], q[1])), hn::Mul(p[2], q[2]));
}

/// Pieces of rays: center + slope s for s from -1 to 1, each coordinate give or take its error.
struct Pieces {
    Vector center[3], slope[3];
    Vector reach;    ///< no coordinate is further from the center
    Vector length;   ///< Euclidean, of slope
    Vector spread;   ///< and of the errors
    Vector cell[3];  ///< of the lattice on which the cubes of candidates are
    Vector edge;     ///< of that lattice, infinite for pieces that have no candidates
    Mask haveCells;  ///< coordinates are known, and so near that whole numbers are apart

    HWY_INLINE Pieces(const std::array<FormColumn, 3>& place, std::size_t first) {
        const Doubles d;
        const Vector inflation = all(1 + roundings);
        Vector error[3];
        reach = all(thriftyCrackleReach);
        haveCells = hn::FirstN(d, hn::Lanes(d));
        for (std::size_t k = 0; k < 3; ++k) {
            center[k] = hn::LoadU(d, place[k].a + first);
            slope[k] = hn::LoadU(d, place[k].b + first);
            error[k] = hn::LoadU(d, place[k].e + first);
            const Vector ahead = hn::Add(hn::Abs(slope[k]), error[k]);
            reach = hn::Max(reach, hn::Mul(ahead, inflation));
            const Vector furthest = hn::Add(hn::Abs(center[k]), ahead);
            haveCells = hn::And(haveCells, hn::Lt(furthest, all(lastCrackleCell)));
        }
        length = hn::Mul(hn::Sqrt(scalarProduct(slope, slope)), inflation);
        spread = hn::Mul(hn::Sqrt(scalarProduct(error, error)), inflation);
        edge = all(infinite);
        for (const double finer : crackleEdges) {
            const Mask fits = hn::And(haveCells, hn::Le(reach, all(finer / 2)));
            edge = hn::IfThenElse(fits, all(finer), edge);
        }
        for (std::size_t k = 0; k < 3; ++k) cell[k] = hn::Floor(hn::Div(center[k], edge));
    }

    /// The lanes that look at the same candidates as one of them, or at none as it does.
    HWY_INLINE Mask like(std::size_t lane) const {
        const double edgeOfLane = hn::ExtractLane(edge, lane);
        Mask same = hn::Eq(edge, all(edgeOfLane));
        if (edgeOfLane == infinite) return same;
        for (const Vector& k : cell) same = hn::And(same, hn::Eq(k, all(hn::ExtractLane(k, lane))));
        return same;
    }
    /// What crackleCandidates() is asked for: infinite where it has none.
    HWY_INLINE CrackleCube cube(std::size_t lane) const {
        const auto at = [&](Vector column) HWY_ATTR { return hn::ExtractLane(column, lane); };
        return {{at(center[0]), at(center[1]), at(center[2])}, at(edge) == infinite ? infinite : at(reach)};
    }
};

/// The least `order` numbers of each lane.
template <std::size_t order>
struct Least {
    Vector number[order];

    HWY_INLINE Least() {
        for (Vector& vector : number) vector = all(infinite);
    }
    HWY_INLINE void add(Vector added) {
        for (std::size_t k = 0; k < order; ++k) {
            const Vector greater = hn::Max(number[k], added);
            number[k] = hn::Min(number[k], added);
            added = greater;
        }
    }
};

/// The least squares of distances of each lane, and what belongs to them.
template <std::size_t order>
struct Nearest {
    Vector square[order], along[order];

    HWY_INLINE Nearest() {
        for (std::size_t k = 0; k < order; ++k) {
            square[k] = all(infinite);
            along[k] = hn::Zero(Doubles());
        }
    }
    HWY_INLINE void add(Vector addedSquare, Vector addedAlong) {
        for (std::size_t k = 0; k < order; ++k) {
            const Mask nearer = hn::Lt(addedSquare, square[k]);
            const Vector furtherSquare = hn::Max(addedSquare, square[k]);
            const Vector furtherAlong = hn::IfThenElse(nearer, along[k], addedAlong);
            square[k] = hn::Min(addedSquare, square[k]);
            along[k] = hn::IfThenElse(nearer, addedAlong, along[k]);
            addedSquare = furtherSquare;
            addedAlong = furtherAlong;
        }
    }
};

/// Distances along the pieces: slope s + [low, high].
struct DistanceLines {
    Vector slope, low, high;
};

/// What is known of the distances from pieces to cell points, in a fourth coordinate `offset` apart.
class Distances {
  public:
    HWY_INLINE Distances(const Pieces& pieces, double offset) : pieces_(pieces), offset_(all(offset)) {}

    /// sqrt(square + offset^2) and its tangent in the middle: d'' is all that makes it rise above.
    HWY_INLINE DistanceLines lines(Vector square, Vector along) const {
        const Vector middle = middleOf(square), length = pieces_.length;
        const Vector rounding = hn::MulAdd(all(roundings), hn::Add(middle, length), pieces_.spread);
        const Mask far = isFar(middle);
        const Vector slope = hn::IfThenElseZero(far, hn::Div(along, middle));
        // d^2 - tangent^2 = (length^2 - slope^2) s^2, and neither is less than middle - |slope|.
        const Vector room = hn::Mul(all(2), hn::Sub(middle, hn::Abs(slope)));
        Vector bend = hn::Div(hn::Sub(hn::Mul(length, length), hn::Mul(slope, slope)), room);
        bend = hn::Min(bend, hn::Mul(all(2), length));
        const Vector fall = hn::IfThenElse(far, hn::Zero(Doubles()), hn::Min(middle, length));
        const Vector rise = hn::IfThenElse(far, bend, length);
        return {slope, hn::Sub(middle, hn::Add(fall, rounding)), hn::Add(middle, hn::Add(rise, rounding))};
    }
    /// The slope of these lines.
    HWY_INLINE Vector slope(Vector square, Vector along) const {
        const Vector middle = middleOf(square);
        return hn::IfThenElseZero(isFar(middle), hn::Div(along, middle));
    }

  private:
    HWY_INLINE Vector middleOf(Vector square) const { return hn::Sqrt(hn::MulAdd(offset_, offset_, square)); }
    HWY_INLINE Mask isFar(Vector middle) const { return hn::Gt(middle, hn::Mul(all(1.001), pieces_.length)); }

    const Pieces& pieces_;
    Vector offset_;
};

/// Forms without roundings, and the size of what they are made of.
struct Forms {
    Vector slope, low, high, size;
};

/// Crackle of pieces that look at the same candidates, of which the nearest `order` (1 to 3) count.
template <std::size_t order>
class CandidateLines {
  public:
    HWY_INLINE CandidateLines(const Pieces& pieces, const CrackleCandidates& found,
                              const CrackleSettings& settings)
        : found_(found), settings_(settings), distances_(pieces, settings.offset) {
        measure(pieces);
        for (std::size_t k = 0; k < order; ++k)
            slope_[k] = distances_.slope(nearest_.square[k], nearest_.along[k]);
        // Distances change by no more than the piece is long.
        const Vector furthest = hn::Mul(
            hn::MulAdd(all(2), hn::Add(pieces.length, pieces.spread), hn::Sqrt(nearest_.square[order - 1])),
            all(1 + roundings));
        limit_ = hn::Mul(furthest, furthest);
    }

    /// The sum of the distances of each order, along the slope of what is in that order in the middle.
    HWY_INLINE Forms sum(Mask lanes) {
        // Of the first order more than the least bounds would not be asked for; they cost less than a branch.
        Least<order> low[order], high[order];
        visit(lanes, [&](std::size_t, const DistanceLines& line) HWY_ATTR {
            for (std::size_t k = 0; k < order; ++k) {
                const Vector turn = hn::Abs(hn::Sub(line.slope, slope_[k]));
                low[k].add(hn::Sub(line.low, turn));
                high[k].add(hn::Add(line.high, turn));
            }
        });
        const Vector zero = hn::Zero(Doubles());
        Forms sum{zero, zero, zero, zero};
        for (std::size_t k = 0; k < order; ++k) {
            const double factor = settings_.form[k];
            if (factor == 0) continue;
            const Vector form = all(factor), least = low[k].number[k], most = high[k].number[k];
            sum.slope = hn::MulAdd(form, slope_[k], sum.slope);
            sum.low = hn::MulAdd(form, factor > 0 ? least : most, sum.low);
            sum.high = hn::MulAdd(form, factor > 0 ? most : least, sum.high);
            sum.size = hn::MulAdd(hn::Abs(form), hn::Add(hn::Abs(most), hn::Abs(slope_[k])), sum.size);
        }
        return sum;
    }

    /// Of `solid`: between the values of the cell points that can be the nearest.
    HWY_INLINE Forms solid(Mask lanes) {
        Vector low[CrackleCandidates::most];
        std::fill(std::begin(low), std::end(low), all(infinite));
        Least<1> high;
        visit(lanes, [&](std::size_t i, const DistanceLines& line) HWY_ATTR {
            const Vector turn = hn::Abs(hn::Sub(line.slope, slope_[0]));
            low[i] = hn::Sub(line.low, turn);
            high.add(hn::Add(line.high, turn));
        });
        Forms forms{hn::Zero(Doubles()), all(infinite), all(-infinite), hn::Zero(Doubles())};
        for (std::size_t i = 0; i < found_.count; ++i) {
            const Mask counts = hn::And(lanes, hn::Le(low[i], high.number[0]));
            if (hn::AllFalse(Doubles(), counts)) continue;
            const Vector value = all(noise(settings_.noiseGenerator, found_.x[i], found_.y[i], found_.z[i]));
            forms.low = hn::IfThenElse(counts, hn::Min(forms.low, value), forms.low);
            forms.high = hn::IfThenElse(counts, hn::Max(forms.high, value), forms.high);
        }
        // Exact where all are the same.
        const Vector greatest = hn::Max(hn::Abs(forms.low), hn::Abs(forms.high));
        forms.size = hn::IfThenZeroElse(hn::Eq(forms.low, forms.high), greatest);
        return forms;
    }

  private:
    HWY_INLINE void measure(const Pieces& pieces) {
        const Doubles d;
        // Members are kept in memory, in loops too.
        Nearest<order> nearest;
        for (std::size_t i = 0; i < found_.count; ++i) {
            const Vector way[3]{hn::Sub(pieces.center[0], all(found_.x[i])),
                                hn::Sub(pieces.center[1], all(found_.y[i])),
                                hn::Sub(pieces.center[2], all(found_.z[i]))};
            const Vector square = scalarProduct(way, way), along = scalarProduct(way, pieces.slope);
            hn::Store(square, d, squares_ + i * hn::Lanes(d));
            hn::Store(along, d, alongs_ + i * hn::Lanes(d));
            if (i < found_.always) nearest.add(square, along);
        }
        nearest_ = nearest;
    }
    /// Those that are near enough to count in some of the lanes, with infinite bounds where they do not
    /// count: no lower one for what is too far, no upper one for what not all of a cube look at.
    template <class Visit>
    HWY_INLINE void visit(Mask lanes, Visit&& each) {
        const Doubles d;
        for (std::size_t i = 0; i < found_.count; ++i) {
            const Vector square = hn::Load(d, squares_ + i * hn::Lanes(d));
            const Mask counts = hn::And(lanes, hn::Le(square, limit_));
            if (hn::AllFalse(d, counts)) continue;
            DistanceLines line = distances_.lines(square, hn::Load(d, alongs_ + i * hn::Lanes(d)));
            const Mask bounds = i < found_.always ? counts : hn::FirstN(d, 0);
            line.low = hn::IfThenElse(counts, line.low, all(infinite));
            line.high = hn::IfThenElse(bounds, line.high, all(infinite));
            each(i, line);
        }
    }

    const CrackleCandidates& found_;
    const CrackleSettings& settings_;
    const Distances distances_;
    Nearest<order> nearest_;
    Vector slope_[order];
    Vector limit_;
    HWY_ALIGN double squares_[CrackleCandidates::most * hn::MaxLanes(Doubles())];
    HWY_ALIGN double alongs_[CrackleCandidates::most * hn::MaxLanes(Doubles())];
};

void writeCrackle(const std::array<FormColumn, 3>& place, const CrackleSettings& settings, std::size_t lanes,
                  const std::array<double*, 3>& result) {
    const Doubles d;
    const Vector half = all(0.5);
    const int order = orderOfCrackle(settings);
    const auto formsOf = [&](const Pieces& pieces, Mask like, const CrackleCandidates& found) HWY_ATTR {
        if (settings.solid) return CandidateLines<1>(pieces, found, settings).solid(like);
        if (order == 1) return CandidateLines<1>(pieces, found, settings).sum(like);
        if (order == 2) return CandidateLines<2>(pieces, found, settings).sum(like);
        return CandidateLines<3>(pieces, found, settings).sum(like);
    };
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(d)) {
        const Pieces pieces(place, first);
        Vector a = half, b = hn::Zero(d), e = hn::IfThenElse(pieces.haveCells, half, all(infinite));
        Mask left = hn::FirstN(d, lanes - first);
        while (!hn::AllFalse(d, left)) {
            const auto lane = static_cast<std::size_t>(hn::FindFirstTrue(d, left));
            const Mask like = hn::And(left, pieces.like(lane));
            left = hn::AndNot(like, left);
            const CrackleCandidates* found = crackleCandidates(pieces.cube(lane), settings.metric, order);
            if (!found) continue;
            const Forms forms = formsOf(pieces, like, *found);
            const Vector reach = hn::Mul(half, hn::Sub(forms.high, forms.low));
            a = hn::IfThenElse(like, hn::Add(forms.low, reach), a);
            b = hn::IfThenElse(like, forms.slope, b);
            e = hn::IfThenElse(like, hn::MulAdd(all(roundings), forms.size, reach), e);
        }
        hn::StoreU(a, d, result[0] + first);
        hn::StoreU(b, d, result[1] + first);
        hn::StoreU(e, d, result[2] + first);
    }
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(writeCrackle);

void writeEuclideanCrackle(const std::array<FormColumn, 3>& place, const CrackleSettings& settings,
                           std::size_t lanes, const std::array<double*, 3>& result) {
    HWY_DYNAMIC_DISPATCH(writeCrackle)(place, settings, lanes, result);
}

}  // namespace isoscope
#endif
