// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. Lattice noise (docs/povray/noise.md, sections 2 to 4) for a vector of
// points.
#if defined(ISOSCOPE_EVALUATE_LATTICE_NOISE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_LATTICE_NOISE_INL
#undef ISOSCOPE_EVALUATE_LATTICE_NOISE_INL
#else
#define ISOSCOPE_EVALUATE_LATTICE_NOISE_INL
#endif

#include <hwy/highway.h>

#include <array>

#include "core/evaluate/algebra/noise_sample-inl.h"
#include "core/numeric/noise.h"
#include "core/numeric/noise_lookup.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// Noise and its derivatives for a batch of points.
struct NoiseColumns {
    HWY_ALIGN double value[batchLanes];
    HWY_ALIGN double x[batchLanes];
    HWY_ALIGN double y[batchLanes];
    HWY_ALIGN double z[batchLanes];

    template <NoiseOrder order = NoiseOrder::gradient>
    HWY_INLINE NoiseSample load(std::size_t i) const {
        const Doubles d;
        const Vector slopeY = order == NoiseOrder::gradient ? hn::Load(d, y + i) : hn::Zero(d);
        return {hn::Load(d, value + i), hn::Load(d, x + i), slopeY, hn::Load(d, z + i)};
    }
    template <NoiseOrder order>
    HWY_INLINE void store(const NoiseSample& sample, std::size_t i) {
        const Doubles d;
        hn::Store(sample.value, d, value + i);
        if constexpr (order == NoiseOrder::value) return;
        hn::Store(sample.x, d, x + i);
        if constexpr (order == NoiseOrder::gradient) hn::Store(sample.y, d, y + i);
        hn::Store(sample.z, d, z + i);
    }
};

/// Lines through a batch of points, p + s way for s from -1 to 1. The columns of y are null where y is 0 all
/// along. Each line may be beside it by `reach` - |way| along an axis.
struct NoiseWays {
    std::array<const double*, 3> way, reach;
};

/// Noise along such lines at s = 0, with derivatives by s.
struct NoiseLines {
    HWY_ALIGN double value[batchLanes];
    HWY_ALIGN double slope[batchLanes];
    HWY_ALIGN double bend[batchLanes];     ///< the second derivative within the cell
    HWY_ALIGN double outside[batchLanes];  ///< at least the part of a half that may be beyond the cell
};

/// Where the lanes of a vector are between the lattice points beside them, along one axis, as LatticePlace.
struct LatticeAxis {
    Vector fraction[2];
    Vector weight[2];

    explicit HWY_INLINE LatticeAxis(const double* fractions) {
        const Vector one = constantVector(1);
        fraction[0] = hn::Load(Doubles(), fractions);
        fraction[1] = hn::Sub(fraction[0], one);
        weight[1] = smoothSteps(fraction[0]);
        weight[0] = hn::Sub(one, weight[1]);
    }
};

/// Places in the value table of the eight corners of each lane's cell.
using LatticePlaces = std::uint8_t[8][vectorLanes];

HWY_INLINE Rows sameLatticeRow(const double* row) {
    return {{constantVector(row[0]), constantVector(row[1]), constantVector(row[2]), constantVector(row[3])}};
}

/// The corners of cells summed up, with x fastest and the products formed in this order because the last bit
/// of the value depends on it. Axes that are flat have one corner; `together` means that all lanes have the
/// cell of the first.
template <NoiseOrder order, bool flatY, bool flatZ, bool together>
class LatticeSum {
  public:
    HWY_INLINE LatticeSum(const LatticeAxis& x, const LatticeAxis& y, const LatticeAxis& z)
        : x_(x), y_(y), z_(z) {
        const Vector zero = hn::Zero(Doubles());
        total_ = {zero, zero, zero, zero};
    }

    HWY_INLINE NoiseSample of(const LatticePlaces& places, const double* table) {
        add<0, 0>(places, table);
        if constexpr (!flatY) add<1, 0>(places, table);
        if constexpr (!flatZ) add<0, 1>(places, table);
        if constexpr (!flatY && !flatZ) add<1, 1>(places, table);
        if constexpr (order != NoiseOrder::value) addSlopes();
        return total_;
    }

  private:
    template <int b, int g>
    HWY_INLINE void add(const LatticePlaces& places, const double* table) {
        addCorner<0, b, g>(places, table);
        addCorner<1, b, g>(places, table);
    }

    template <int a, int b, int g>
    HWY_INLINE void addCorner(const LatticePlaces& places, const double* table) {
        constexpr int corner = a + 2 * b + 4 * g;
        const Rows row =
            together ? sameLatticeRow(table + places[corner][0]) : loadRows(table, places[corner]);
        // The weight and the fraction of a flat axis are 1 and 0.
        Vector weight = x_.weight[a];
        if constexpr (!flatY) weight = hn::Mul(weight, y_.weight[b]);
        if constexpr (!flatZ) weight = hn::Mul(weight, z_.weight[g]);
        Vector plane = hn::Mul(row.v[0], constantVector(0.5));
        plane = hn::Add(plane, hn::Mul(row.v[1], x_.fraction[a]));
        if constexpr (!flatY) plane = hn::Add(plane, hn::Mul(row.v[2], y_.fraction[b]));
        if constexpr (!flatZ) plane = hn::Add(plane, hn::Mul(row.v[3], z_.fraction[g]));
        total_.value = hn::Add(total_.value, hn::Mul(weight, plane));
        if constexpr (order != NoiseOrder::value) {
            total_.x = hn::MulAdd(weight, row.v[1], total_.x);
            if constexpr (order == NoiseOrder::gradient) total_.y = hn::MulAdd(weight, row.v[2], total_.y);
            total_.z = hn::MulAdd(weight, row.v[3], total_.z);
            planes_[corner] = plane;
        }
    }

    /// What the weights' slopes add to the derivatives: the differences of the planes across one axis,
    /// weighted along the other two. On a flat axis the slope of the weights is 0.
    HWY_INLINE void addSlopes() {
        total_.x = hn::MulAdd(smoothStepSlopes(x_.fraction[0]),
                              across<flatY, flatZ, 2, 4>(y_.weight, z_.weight, 1), total_.x);
        if constexpr (!flatY && order == NoiseOrder::gradient)
            total_.y = hn::MulAdd(smoothStepSlopes(y_.fraction[0]),
                                  across<false, flatZ, 1, 4>(x_.weight, z_.weight, 2), total_.y);
        if constexpr (!flatZ)
            total_.z = hn::MulAdd(smoothStepSlopes(z_.fraction[0]),
                                  across<false, flatY, 1, 2>(x_.weight, y_.weight, 4), total_.z);
    }

    /// Across the axis whose corners are `step` apart; `u` and `v` are the weights of those that are `stepU`
    /// and `stepV` apart.
    template <bool flatU, bool flatV, int stepU, int stepV>
    HWY_INLINE Vector across(const Vector (&u)[2], const Vector (&v)[2], int step) const {
        const auto rise = [&](int low) HWY_ATTR { return hn::Sub(planes_[low + step], planes_[low]); };
        const auto along = [&](int low) HWY_ATTR {
            if constexpr (flatU) return rise(low);
            return hn::MulAdd(u[1], rise(low + stepU), hn::Mul(u[0], rise(low)));
        };
        if constexpr (flatV) return along(0);
        return hn::MulAdd(v[1], along(stepV), hn::Mul(v[0], along(0)));
    }

    const LatticeAxis &x_, &y_, &z_;
    NoiseSample total_;
    Vector planes_[order != NoiseOrder::value ? 8 : 1];
};

/// The corners of cells summed up as LatticeSum does, along lines.
template <bool flatY, bool flatZ, bool together>
class LatticeLineSum {
  public:
    /// At a corner or between some: the value and its derivatives by s.
    struct Jet {
        Vector value, slope, bend;
    };

    HWY_INLINE LatticeLineSum(const LatticeAxis& x, const LatticeAxis& y, const LatticeAxis& z, Vector wayX,
                              Vector wayY, Vector wayZ)
        : x_(x, wayX), y_(y, wayY), z_(z, wayZ) {}

    HWY_INLINE Jet of(const LatticePlaces& places, const double* table) const {
        const Jet near = plane<0>(places, table);
        if constexpr (flatZ) return near;
        return between(z_, near, plane<1>(places, table));
    }

  private:
    struct Axis {
        const LatticeAxis& place;
        Vector way, rise, bend;  ///< of the point, and of the weight of the upper end

        HWY_INLINE Axis(const LatticeAxis& along, Vector pointWay)
            : place(along),
              way(pointWay),
              rise(hn::Mul(smoothStepSlopes(along.fraction[0]), pointWay)),
              bend(hn::Mul(hn::MulAdd(along.fraction[0], constantVector(-12), constantVector(6)),
                           hn::Mul(pointWay, pointWay))) {}
    };

    template <int g>
    HWY_INLINE Jet plane(const LatticePlaces& places, const double* table) const {
        const Jet near = edge<0, g>(places, table);
        if constexpr (flatY) return near;
        return between(y_, near, edge<1, g>(places, table));
    }
    template <int b, int g>
    HWY_INLINE Jet edge(const LatticePlaces& places, const double* table) const {
        const Jet low = corner<0, b, g>(places, table), high = corner<1, b, g>(places, table);
        const Vector rise = hn::Sub(high.value, low.value), steeper = hn::Sub(high.slope, low.slope);
        return {hn::MulAdd(x_.place.weight[1], rise, low.value),
                hn::MulAdd(x_.rise, rise, hn::MulAdd(x_.place.weight[1], steeper, low.slope)),
                hn::MulAdd(x_.bend, rise, hn::Mul(hn::Add(x_.rise, x_.rise), steeper))};
    }
    /// Straight along the line: without a bend.
    template <int a, int b, int g>
    HWY_INLINE Jet corner(const LatticePlaces& places, const double* table) const {
        constexpr int number = a + 2 * b + 4 * g;
        const Rows row =
            together ? sameLatticeRow(table + places[number][0]) : loadRows(table, places[number]);
        Vector value = hn::Mul(row.v[0], constantVector(0.5)), slope = hn::Mul(row.v[1], x_.way);
        value = hn::MulAdd(row.v[1], x_.place.fraction[a], value);
        if constexpr (!flatY) value = hn::MulAdd(row.v[2], y_.place.fraction[b], value);
        // On a flat axis too: a line may lead out of the plane.
        slope = hn::MulAdd(row.v[2], y_.way, slope);
        if constexpr (!flatZ) value = hn::MulAdd(row.v[3], z_.place.fraction[g], value);
        slope = hn::MulAdd(row.v[3], z_.way, slope);
        return {value, slope, hn::Zero(Doubles())};
    }
    static HWY_INLINE Jet between(const Axis& axis, const Jet& low, const Jet& high) {
        const Vector rise = hn::Sub(high.value, low.value), steeper = hn::Sub(high.slope, low.slope);
        const Vector bend = hn::MulAdd(axis.place.weight[1], hn::Sub(high.bend, low.bend), low.bend);
        return {hn::MulAdd(axis.place.weight[1], rise, low.value),
                hn::MulAdd(axis.rise, rise, hn::MulAdd(axis.place.weight[1], steeper, low.slope)),
                hn::MulAdd(axis.bend, rise, hn::MulAdd(hn::Add(axis.rise, axis.rise), steeper, bend))};
    }

    Axis x_, y_, z_;
};

/// The cells of a batch of points. What is done for all of them comes in rounds, each for all vectors: one
/// vector from its coordinates to its noise is a chain of steps that wait for each other, too long for the
/// processor to begin with the next one meanwhile. Far corners without weight are left out: they would add 0,
/// to the derivatives too, since the weight's slope is 0 at both ends.
class LatticeCells {
  public:
    /// Of `lanes` points, whole vectors; only of the vectors whose bits are set in `wanted`. Without a column
    /// for y, that is 0.
    HWY_INLINE LatticeCells(const std::array<const double*, 3>& point, std::size_t lanes,
                            std::uint64_t wanted)
        : lanes_(lanes), wanted_(wanted) {
        // No member: those are kept in memory.
        Extent extent;
        if (point[1] == nullptr)
            placeAll<true>(point, extent);
        else
            placeAll<false>(point, extent);
        flat_[1] = isZero(extent.besideY);
        flat_[2] = isZero(extent.besideZ);
        if (!flat_[1])
            lookUpAll<Plane::none>();
        else
            extent.isGround() ? lookUpAll<Plane::ground>() : lookUpAll<Plane::any>();
    }

    /// L_component of section 4.
    template <NoiseOrder order>
    HWY_INLINE void sample(int component, NoiseColumns& noise) const {
        const double* table = latticeValueTable.data() + 4 * component;
        if (flat_[2])
            flat_[1] ? sum<order, true, true>(table, noise) : sum<order, false, true>(table, noise);
        else
            flat_[1] ? sum<order, true, false>(table, noise) : sum<order, false, false>(table, noise);
    }

    /// The same along lines.
    HWY_INLINE void sampleAlong(int component, const NoiseWays& ways, NoiseLines& lines) const {
        const double* table = latticeValueTable.data() + 4 * component;
        if (flat_[2])
            flat_[1] ? sumAlong<true, true>(table, ways, lines) : sumAlong<false, true>(table, ways, lines);
        else
            flat_[1] ? sumAlong<true, false>(table, ways, lines) : sumAlong<false, false>(table, ways, lines);
    }

  private:
    bool isWanted(std::size_t i) const { return (wanted_ >> (i / vectorLanes)) & 1u; }
    bool isTogether(std::size_t i) const { return (together_ >> (i / vectorLanes)) & 1u; }

    static HWY_INLINE bool isZero(Vector vector) {
        return hn::AllTrue(Doubles(), hn::Eq(vector, hn::Zero(Doubles())));
    }

    /// How far points are from the lattice along y and z, and their cells from that at y = 0, lane by lane.
    struct Extent {
        Vector besideY, besideZ;
        hn::Vec<WholeNumbers> cellsY;

        HWY_INLINE Extent()
            : besideY(hn::Zero(Doubles())), besideZ(besideY), cellsY(hn::Zero(WholeNumbers())) {}
        HWY_INLINE bool isGround() const {
            return hn::AllTrue(WholeNumbers(), hn::Eq(cellsY, hn::Zero(WholeNumbers())));
        }
    };
    /// What all points have in common.
    enum class Plane {
        none,
        any,     ///< they are on lattice points along y
        ground,  ///< y = 0
    };

    template <bool ground>
    HWY_INLINE void placeAll(const std::array<const double*, 3>& point, Extent& extent) {
        for (std::size_t i = 0; i < lanes_; i += vectorLanes)
            if (isWanted(i)) place<ground>(point, i, extent);
    }
    /// Finds the lattice points below the lanes from `i` on, and how far these are from there.
    template <bool ground>
    HWY_INLINE void place(const std::array<const double*, 3>& point, std::size_t i, Extent& extent) {
        const WholeNumbers whole;
        // Axis by axis by name: a loop would keep its results in memory.
        const PlaceAlong x = placeAlong<0>(point, i), z = placeAlong<2>(point, i);
        auto apart = hn::Or(fromFirst(x.cell), fromFirst(z.cell));
        if constexpr (!ground) {
            const PlaceAlong y = placeAlong<1>(point, i);
            extent.besideY = hn::Max(extent.besideY, hn::Abs(y.fraction));
            extent.cellsY = hn::Or(extent.cellsY, y.cell);
            apart = hn::Or(apart, fromFirst(y.cell));
        }
        extent.besideZ = hn::Max(extent.besideZ, hn::Abs(z.fraction));
        // Which of them are together cannot be foreseen: no branch.
        const bool together = vectorLanes > 1 && hn::AllTrue(whole, hn::Eq(apart, hn::Zero(whole)));
        together_ |= std::uint64_t{together} << (i / vectorLanes);
    }
    /// What sets cells apart from the first lane's.
    static HWY_INLINE hn::Vec<WholeNumbers> fromFirst(hn::Vec<WholeNumbers> cell) {
        return hn::Xor(cell, hn::Set(WholeNumbers(), hn::GetLane(cell)));
    }

    struct PlaceAlong {
        Vector fraction;
        hn::Vec<WholeNumbers> cell;
    };
    template <std::size_t axis>
    HWY_INLINE PlaceAlong placeAlong(const std::array<const double*, 3>& point, std::size_t i) {
        const Doubles d;
        const WholeNumbers whole;
        const Vector t = latticeCoordinates(hn::LoadU(d, point[axis] + i));
        const Mask positive = hn::Ge(t, hn::Zero(d));
        const Vector shifted = hn::IfThenElse(positive, t, hn::Sub(t, constantVector(1 - 1e-10)));
        const auto cell = wholeNumbers(shifted);
        const Vector fraction = hn::Sub(t, hn::PromoteTo(d, cell));
        hn::Store(fraction, d, fractions_[axis] + i);
        hn::Store(hn::And(hn::Add(cell, hn::Set(whole, 10000)), hn::Set(whole, 4095)), whole,
                  indices_[axis] + i);
        return {fraction, cell};
    }

    template <Plane plane>
    HWY_INLINE void lookUpAll() {
        for (std::size_t i = 0; i < lanes_; i += vectorLanes)
            if (isWanted(i)) lookUp<plane>(i);
    }
    /// Lane by lane: looking up is faster in general registers. Single variables keep it there.
    template <Plane plane>
    HWY_INLINE void lookUp(std::size_t first) {
        const auto* hash = latticeLookup.hash.data();
        const auto* ground = latticeLookup.ground.data();
        const auto* entry = latticeLookup.entry.data();
        LatticePlaces& places = places_[first / vectorLanes];
        const std::size_t count = isTogether(first) ? 1 : vectorLanes;
        for (std::size_t i = 0; i < count; ++i) {
            const auto index = [&](int axis) { return static_cast<unsigned>(indices_[axis][first + i]); };
            const unsigned x = index(0), y = plane == Plane::ground ? 0 : index(1);
            const unsigned z = index(2), nextZ = (z + 1) & 4095u, nextY = (y + 1) & 4095u;
            const unsigned left = hash[x], right = hash[x + 1];
            const unsigned row0 = plane == Plane::ground ? ground[x] : hash[left ^ y];
            const unsigned row1 = plane == Plane::ground ? ground[x + 1] : hash[right ^ y];
            places[0][i] = entry[row0 ^ z];
            places[1][i] = entry[row1 ^ z];
            places[4][i] = entry[row0 ^ nextZ];
            places[5][i] = entry[row1 ^ nextZ];
            if constexpr (plane == Plane::none) {
                const unsigned row2 = hash[left ^ nextY], row3 = hash[right ^ nextY];
                places[2][i] = entry[row2 ^ z];
                places[3][i] = entry[row3 ^ z];
                places[6][i] = entry[row2 ^ nextZ];
                places[7][i] = entry[row3 ^ nextZ];
            }
        }
    }

    template <NoiseOrder order, bool flatY, bool flatZ>
    HWY_INLINE void sum(const double* table, NoiseColumns& noise) const {
        for (std::size_t i = 0; i < lanes_; i += vectorLanes) {
            if (!isWanted(i)) continue;
            const LatticeAxis x(fractions_[0] + i), z(fractions_[2] + i);
            // Not read where it is flat.
            const LatticeAxis y = flatY ? x : LatticeAxis(fractions_[1] + i);
            const LatticePlaces& places = places_[i / vectorLanes];
            noise.store<order>(isTogether(i)
                                   ? LatticeSum<order, flatY, flatZ, true>(x, y, z).of(places, table)
                                   : LatticeSum<order, flatY, flatZ, false>(x, y, z).of(places, table),
                               i);
        }
    }

    template <bool flatY, bool flatZ>
    HWY_INLINE void sumAlong(const double* table, const NoiseWays& ways, NoiseLines& lines) const {
        const Doubles d;
        const Vector zero = hn::Zero(d);
        const bool ground = ways.way[1] == nullptr;
        for (std::size_t i = 0; i < lanes_; i += vectorLanes) {
            if (!isWanted(i)) continue;
            const LatticeAxis x(fractions_[0] + i), z(fractions_[2] + i);
            const LatticeAxis y = ground ? x : LatticeAxis(fractions_[1] + i);
            const Vector wayX = hn::LoadU(d, ways.way[0] + i), wayZ = hn::LoadU(d, ways.way[2] + i);
            const Vector wayY = ground ? zero : hn::LoadU(d, ways.way[1] + i);
            const LatticePlaces& places = places_[i / vectorLanes];
            const auto jet =
                isTogether(i)
                    ? jetOf(LatticeLineSum<flatY, flatZ, true>(x, y, z, wayX, wayY, wayZ).of(places, table))
                    : jetOf(LatticeLineSum<flatY, flatZ, false>(x, y, z, wayX, wayY, wayZ).of(places, table));
            hn::Store(jet.value, d, lines.value + i);
            hn::Store(jet.slope, d, lines.slope + i);
            hn::Store(jet.bend, d, lines.bend + i);
            Vector outside = hn::Max(outsideOf(x, ways.reach[0] + i), outsideOf(z, ways.reach[2] + i));
            if (!ground) outside = hn::Max(outside, outsideOf(y, ways.reach[1] + i));
            hn::Store(outside, d, lines.outside + i);
        }
    }
    template <class Jet>
    static HWY_INLINE LatticeLineSum<false, false, false>::Jet jetOf(const Jet& jet) {
        return {jet.value, jet.slope, jet.bend};
    }
    /// The part of the way along an axis behind the nearer end of the cell.
    static HWY_INLINE Vector outsideOf(const LatticeAxis& axis, const double* reaches) {
        const Vector reach = hn::Load(Doubles(), reaches);
        const Vector room = hn::Min(axis.fraction[0], hn::Neg(axis.fraction[1]));
        const Vector beyond = hn::Sub(hn::MulAdd(reach, constantVector(1e-14), reach),
                                      hn::Sub(hn::Max(room, hn::Zero(Doubles())), constantVector(1e-15)));
        const Vector part = hn::Div(beyond, reach);
        return hn::IfThenElseZero(
            hn::And(hn::Gt(reach, hn::Zero(Doubles())), hn::Gt(part, hn::Zero(Doubles()))),
            hn::Min(part, constantVector(1)));
    }

    std::size_t lanes_;
    std::uint64_t wanted_, together_ = 0;  ///< a bit for each vector
    bool flat_[3] = {};                    ///< all points are on lattice points of the axis; not of the first
    HWY_ALIGN double fractions_[3][batchLanes];
    HWY_ALIGN std::int32_t indices_[3][batchLanes];
    LatticePlaces places_[batchLanes / vectorLanes];
};

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
