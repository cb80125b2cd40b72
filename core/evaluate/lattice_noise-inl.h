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
    HWY_ALIGN std::int32_t index[vectorLanes];

    explicit HWY_INLINE LatticeAxis(Vector coordinate) {
        const Doubles d;
        const WholeNumbers cells;
        const Vector t = latticeCoordinates(coordinate), one = constantVector(1);
        const Mask positive = hn::Ge(t, hn::Zero(d));
        const Vector shifted = hn::IfThenElse(positive, t, hn::Sub(t, constantVector(1 - 1e-10)));
        const auto cell = wholeNumbers(shifted);
        fraction[0] = hn::Sub(t, hn::PromoteTo(d, cell));
        fraction[1] = hn::Sub(fraction[0], one);
        weight[1] = smoothSteps(fraction[0]);
        weight[0] = hn::Sub(one, weight[1]);
        hn::Store(hn::And(hn::Add(cell, hn::Set(cells, 10000)), hn::Set(cells, 4095)), cells, index);
    }

    /// Whether the far corners have no weight, as in noise(x, 0, z).
    HWY_INLINE bool flat() const { return hn::AllTrue(Doubles(), hn::Eq(weight[1], hn::Zero(Doubles()))); }
};

/// The cells of a vector of points. Far corners without weight are left out: they would add 0, to the
/// derivatives too, since the weight's slope is 0 at both ends.
class LatticeCells {
  public:
    HWY_INLINE LatticeCells(Vector px, Vector py, Vector pz)
        : x_(px), y_(py), z_(pz), flatY_(y_.flat()), flatZ_(z_.flat()) {
        if (flatY_)
            findRows<true>();
        else
            findRows<false>();
    }

    /// L_component of section 4. The corners are summed with x fastest and the products formed in this order
    /// because the last bit of the value depends on it.
    template <NoiseOrder order>
    HWY_INLINE NoiseSample sample(int component) const {
        const double* table = latticeValues().data() + 4 * component;
        Sums<order> sums(*this);
        sums.template add<0, 0>(table);
        if (!flatY_) sums.template add<1, 0>(table);
        if (!flatZ_) {
            sums.template add<0, 1>(table);
            if (!flatY_) sums.template add<1, 1>(table);
        }
        return sums.finish();
    }

  private:
    /// Lane by lane: looking up is faster in general registers. Single variables keep it there.
    template <bool flatY>
    HWY_INLINE void findRows() {
        const LatticeLookup& lookup = latticeLookup();
        const auto* hash = lookup.hash.data();
        const auto* entry = lookup.entry.data();
        for (std::size_t i = 0; i < vectorLanes; ++i) {
            const unsigned x = x_.index[i], y = y_.index[i], nextY = (y + 1) & 4095u;
            const unsigned z = z_.index[i], nextZ = (z + 1) & 4095u;
            const unsigned left = hash[x], right = hash[x + 1];
            const unsigned row0 = hash[left ^ y], row1 = hash[right ^ y];
            places_[0][i] = entry[row0 ^ z];
            places_[1][i] = entry[row1 ^ z];
            places_[4][i] = entry[row0 ^ nextZ];
            places_[5][i] = entry[row1 ^ nextZ];
            if constexpr (!flatY) {
                const unsigned row2 = hash[left ^ nextY], row3 = hash[right ^ nextY];
                places_[2][i] = entry[row2 ^ z];
                places_[3][i] = entry[row3 ^ z];
                places_[6][i] = entry[row2 ^ nextZ];
                places_[7][i] = entry[row3 ^ nextZ];
            }
        }
    }

    template <NoiseOrder order>
    struct Sums {
        explicit HWY_INLINE Sums(const LatticeCells& c) : cells(c) {
            const Vector zero = hn::Zero(Doubles());
            total = {zero, zero, zero, zero};
            if constexpr (order == NoiseOrder::gradient)
                for (Vector& plane : planes) plane = zero;
        }

        template <int b, int g>
        HWY_INLINE void add(const double* table) {
            addCorner<0, b, g>(table);
            addCorner<1, b, g>(table);
        }

        template <int a, int b, int g>
        HWY_INLINE void addCorner(const double* table) {
            const LatticeAxis &x = cells.x_, &y = cells.y_, &z = cells.z_;
            constexpr int corner = a + 2 * b + 4 * g;
            const Rows row = loadRows(table, cells.places_[corner]);
            const Vector weight = hn::Mul(hn::Mul(x.weight[a], y.weight[b]), z.weight[g]);
            Vector plane = hn::Mul(row.v[0], constantVector(0.5));
            plane = hn::Add(plane, hn::Mul(row.v[1], x.fraction[a]));
            plane = hn::Add(plane, hn::Mul(row.v[2], y.fraction[b]));
            plane = hn::Add(plane, hn::Mul(row.v[3], z.fraction[g]));
            total.value = hn::Add(total.value, hn::Mul(weight, plane));
            if constexpr (order == NoiseOrder::gradient) {
                total.x = hn::MulAdd(weight, row.v[1], total.x);
                total.y = hn::MulAdd(weight, row.v[2], total.y);
                total.z = hn::MulAdd(weight, row.v[3], total.z);
                planes[corner] = plane;
            }
        }

        /// The difference of the planes across one axis, weighted along the other two.
        static HWY_INLINE Vector across(const Vector (&u)[2], const Vector (&v)[2], Vector d00, Vector d10,
                                        Vector d01, Vector d11) {
            const Vector near = hn::MulAdd(u[1], d10, hn::Mul(u[0], d00));
            const Vector far = hn::MulAdd(u[1], d11, hn::Mul(u[0], d01));
            return hn::MulAdd(v[1], far, hn::Mul(v[0], near));
        }

        HWY_INLINE NoiseSample finish() {
            if constexpr (order == NoiseOrder::gradient) {
                const LatticeAxis &x = cells.x_, &y = cells.y_, &z = cells.z_;
                const auto d = [this](int low, int step)
                                   HWY_ATTR { return hn::Sub(planes[low + step], planes[low]); };
                const Vector alongX = across(y.weight, z.weight, d(0, 1), d(2, 1), d(4, 1), d(6, 1));
                const Vector alongY = across(x.weight, z.weight, d(0, 2), d(1, 2), d(4, 2), d(5, 2));
                const Vector alongZ = across(x.weight, y.weight, d(0, 4), d(1, 4), d(2, 4), d(3, 4));
                total.x = hn::MulAdd(smoothStepSlopes(x.fraction[0]), alongX, total.x);
                total.y = hn::MulAdd(smoothStepSlopes(y.fraction[0]), alongY, total.y);
                total.z = hn::MulAdd(smoothStepSlopes(z.fraction[0]), alongZ, total.z);
            }
            return total;
        }

        const LatticeCells& cells;
        NoiseSample total;
        Vector planes[order == NoiseOrder::gradient ? 8 : 1];
    };

    LatticeAxis x_, y_, z_;
    bool flatY_, flatZ_;
    std::uint8_t places_[8][vectorLanes];
};

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
