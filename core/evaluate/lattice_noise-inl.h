// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. Lattice noise (spec/noise.md, sections 2 to 4) for a vector of points.
#if defined(ISOSCOPE_EVALUATE_LATTICE_NOISE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_LATTICE_NOISE_INL
#undef ISOSCOPE_EVALUATE_LATTICE_NOISE_INL
#else
#define ISOSCOPE_EVALUATE_LATTICE_NOISE_INL
#endif

#include <hwy/highway.h>

#include "core/evaluate/noise_sample-inl.h"
#include "core/numeric/noise.h"
#include "core/numeric/noise_lookup.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// One coordinate of all lanes, as LatticePlace.
struct LatticeAxis {
    Vector fraction[2];
    Vector weight[2];
    hn::Vec<WholeNumbers> cell;

    explicit HWY_INLINE LatticeAxis(Vector coordinate) {
        const Doubles d;
        const Vector t = latticeCoordinates(coordinate), one = constantVector(1);
        const Mask positive = hn::Ge(t, hn::Zero(d));
        const Vector shifted = hn::IfThenElse(positive, t, hn::Sub(t, constantVector(1 - 1e-10)));
        cell = wholeNumbers(shifted);
        fraction[0] = hn::Sub(t, hn::PromoteTo(d, cell));
        fraction[1] = hn::Sub(fraction[0], one);
        weight[1] = smoothSteps(fraction[0]);
        weight[0] = hn::Sub(one, weight[1]);
    }

    /// Whether all lanes are on lattice points, as in noise(x, 0, z): the far corners have no weight.
    HWY_INLINE bool flat() const { return hn::AllTrue(Doubles(), hn::Eq(fraction[0], hn::Zero(Doubles()))); }
    HWY_INLINE auto cellOfFirst() const { return hn::Eq(cell, hn::Set(WholeNumbers(), hn::GetLane(cell))); }
    HWY_INLINE void storeIndices(std::int32_t* to) const {
        const WholeNumbers d;
        hn::Store(hn::And(hn::Add(cell, hn::Set(d, 10000)), hn::Set(d, 4095)), d, to);
    }
};

/// Places in the value table of the eight corners of each lane's cell.
using LatticePlaces = std::uint8_t[8][vectorLanes];

/// Of the lane `i`. Looking up is faster in general registers; single variables keep it there.
template <bool flatY>
HWY_INLINE void lookUpCell(unsigned x, unsigned y, unsigned z, std::size_t i, LatticePlaces& places) {
    const auto* hash = latticeLookup.hash.data();
    const auto* entry = latticeLookup.entry.data();
    const unsigned nextY = (y + 1) & 4095u, nextZ = (z + 1) & 4095u;
    const unsigned left = hash[x], right = hash[x + 1];
    const unsigned row0 = hash[left ^ y], row1 = hash[right ^ y];
    places[0][i] = entry[row0 ^ z];
    places[1][i] = entry[row1 ^ z];
    places[4][i] = entry[row0 ^ nextZ];
    places[5][i] = entry[row1 ^ nextZ];
    if constexpr (!flatY) {
        const unsigned row2 = hash[left ^ nextY], row3 = hash[right ^ nextY];
        places[2][i] = entry[row2 ^ z];
        places[3][i] = entry[row3 ^ z];
        places[6][i] = entry[row2 ^ nextZ];
        places[7][i] = entry[row3 ^ nextZ];
    }
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
        if constexpr (order == NoiseOrder::gradient) addSlopes();
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
        const Rows row = together ? sameRow(table + places[corner][0]) : loadRows(table, places[corner]);
        // The weight and the fraction of a flat axis are 1 and 0.
        Vector weight = x_.weight[a];
        if constexpr (!flatY) weight = hn::Mul(weight, y_.weight[b]);
        if constexpr (!flatZ) weight = hn::Mul(weight, z_.weight[g]);
        Vector plane = hn::Mul(row.v[0], constantVector(0.5));
        plane = hn::Add(plane, hn::Mul(row.v[1], x_.fraction[a]));
        if constexpr (!flatY) plane = hn::Add(plane, hn::Mul(row.v[2], y_.fraction[b]));
        if constexpr (!flatZ) plane = hn::Add(plane, hn::Mul(row.v[3], z_.fraction[g]));
        total_.value = hn::Add(total_.value, hn::Mul(weight, plane));
        if constexpr (order == NoiseOrder::gradient) {
            total_.x = hn::MulAdd(weight, row.v[1], total_.x);
            total_.y = hn::MulAdd(weight, row.v[2], total_.y);
            total_.z = hn::MulAdd(weight, row.v[3], total_.z);
            planes_[corner] = plane;
        }
    }

    static HWY_INLINE Rows sameRow(const double* row) {
        return {
            {constantVector(row[0]), constantVector(row[1]), constantVector(row[2]), constantVector(row[3])}};
    }

    /// What the weights' slopes add to the derivatives: the differences of the planes across one axis,
    /// weighted along the other two. On a flat axis the slope of the weights is 0.
    HWY_INLINE void addSlopes() {
        total_.x = hn::MulAdd(smoothStepSlopes(x_.fraction[0]),
                              across<flatY, flatZ, 2, 4>(y_.weight, z_.weight, 1), total_.x);
        if constexpr (!flatY)
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
    Vector planes_[order == NoiseOrder::gradient ? 8 : 1];
};

/// The cells of a vector of points. Far corners without weight are left out: they would add 0, to the
/// derivatives too, since the weight's slope is 0 at both ends.
class LatticeCells {
  public:
    HWY_INLINE LatticeCells(Vector px, Vector py, Vector pz)
        : x_(px), y_(py), z_(pz), flatY_(y_.flat()), flatZ_(z_.flat()) {
        const auto same = hn::And(hn::And(x_.cellOfFirst(), y_.cellOfFirst()), z_.cellOfFirst());
        together_ = vectorLanes > 1 && hn::AllTrue(WholeNumbers(), same);
        if (flatY_)
            lookUp<true>();
        else
            lookUp<false>();
    }

    /// L_component of section 4.
    template <NoiseOrder order>
    HWY_INLINE NoiseSample sample(int component) const {
        const double* table = latticeValueTable.data() + 4 * component;
        if (flatZ_)
            return flatY_ ? sum<order, true, true, false>(table) : sum<order, false, true, false>(table);
        if (flatY_)
            return together_ ? sum<order, true, false, true>(table) : sum<order, true, false, false>(table);
        return together_ ? sum<order, false, false, true>(table) : sum<order, false, false, false>(table);
    }

  private:
    template <bool flatY>
    HWY_INLINE void lookUp() {
        HWY_ALIGN std::int32_t x[vectorLanes], y[vectorLanes], z[vectorLanes];
        x_.storeIndices(x);
        y_.storeIndices(y);
        z_.storeIndices(z);
        const auto at = [&](std::size_t i) HWY_ATTR {
            lookUpCell<flatY>(static_cast<unsigned>(x[i]), static_cast<unsigned>(y[i]),
                              static_cast<unsigned>(z[i]), i, places_);
        };
        at(0);
        // Flat axes along z are rare and read all lanes.
        if (together_ && !flatZ_) return;
        for (std::size_t i = 1; i < vectorLanes; ++i) at(i);
    }

    template <NoiseOrder order, bool flatY, bool flatZ, bool together>
    HWY_INLINE NoiseSample sum(const double* table) const {
        return LatticeSum<order, flatY, flatZ, together>(x_, y_, z_).of(places_, table);
    }

    LatticeAxis x_, y_, z_;
    bool flatY_, flatZ_, together_;
    LatticePlaces places_;
};

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
