// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. Gradient noise (docs/povray/noise.md, section 5) for a vector of points.
#if defined(ISOSCOPE_EVALUATE_GRADIENT_NOISE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_GRADIENT_NOISE_INL
#undef ISOSCOPE_EVALUATE_GRADIENT_NOISE_INL
#else
#define ISOSCOPE_EVALUATE_GRADIENT_NOISE_INL
#endif

#include <hwy/highway.h>

#include "core/evaluate/algebra/noise_sample-inl.h"
#include "core/numeric/noise.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// One coordinate of all lanes, as GradientPlace.
struct GradientAxis {
    Vector distance[2];
    Vector step;
    HWY_ALIGN double cell[vectorLanes];

    explicit HWY_INLINE GradientAxis(Vector coordinate) {
        const Doubles d;
        const Vector shifted = hn::Add(latticeCoordinates(coordinate), constantVector(10000000.023157213));
        const Vector base = hn::Floor(shifted);
        distance[0] = hn::Sub(shifted, base);
        distance[1] = hn::Sub(distance[0], constantVector(1));
        step = smoothSteps(distance[0]);
        hn::Store(base, d, cell);
    }
    unsigned index(std::size_t lane) const {
        return static_cast<unsigned>(static_cast<std::int64_t>(cell[lane])) & 2047u;
    }
};

class GradientCells {
  public:
    HWY_INLINE GradientCells(Vector px, Vector py, Vector pz) : x_(px), y_(py), z_(pz) {
        const GradientNoiseTables& tables = gradientNoiseTables();
        const auto* hash = tables.hash.data();
        for (std::size_t i = 0; i < vectorLanes; ++i) {
            const unsigned x = x_.index(i), y = y_.index(i), nextY = (y + 1) & 2047u;
            const unsigned z = z_.index(i), nextZ = (z + 1) & 2047u;
            const unsigned left = hash[x], right = hash[(x + 1) & 2047u];
            const unsigned row0 = hash[left + y], row1 = hash[right + y];
            const unsigned row2 = hash[left + nextY], row3 = hash[right + nextY];
            places_[0][i] = place(row0 + z);
            places_[1][i] = place(row1 + z);
            places_[2][i] = place(row2 + z);
            places_[3][i] = place(row3 + z);
            places_[4][i] = place(row0 + nextZ);
            places_[5][i] = place(row1 + nextZ);
            places_[6][i] = place(row2 + nextZ);
            places_[7][i] = place(row3 + nextZ);
        }
    }

    /// K of section 5, in the order of gradientNoise().
    template <NoiseOrder order>
    HWY_INLINE NoiseSample sample() const {
        // Rows have three numbers; the fourth belongs to the next row or, behind the last one, to the hash.
        static_assert(offsetof(GradientNoiseTables, hash) == sizeof(GradientNoiseTables::gradients));
        const double* table = gradientNoiseTables().gradients[0].data();
        const auto corner = [&](int a, int b, int g) HWY_ATTR {
            const Rows row = loadRows(table, places_[a + 2 * b + 4 * g]);
            Vector value = hn::Mul(row.v[0], x_.distance[a]);
            value = hn::Add(value, hn::Mul(row.v[1], y_.distance[b]));
            value = hn::Add(value, hn::Mul(row.v[2], z_.distance[g]));
            return NoiseSample{value, row.v[0], row.v[1], row.v[2]};
        };
        const auto plane = [&](int g) HWY_ATTR {
            const NoiseSample near = alongAxis<order>(x_, 0, corner(0, 0, g), corner(1, 0, g));
            const NoiseSample far = alongAxis<order>(x_, 0, corner(0, 1, g), corner(1, 1, g));
            return alongAxis<order>(y_, 1, near, far);
        };
        return alongAxis<order>(z_, 2, plane(0), plane(1));
    }

  private:
    static HWY_INLINE std::uint16_t place(unsigned row) {
        return static_cast<std::uint16_t>(3 * (row & 2047u));
    }
    static HWY_INLINE Vector lerp(Vector t, Vector a, Vector b) {
        return hn::Add(a, hn::Mul(t, hn::Sub(b, a)));
    }

    /// Interpolation along an axis, whose weight has a derivative of its own.
    template <NoiseOrder order>
    static HWY_INLINE NoiseSample alongAxis(const GradientAxis& axis, int number, const NoiseSample& a,
                                            const NoiseSample& b) {
        NoiseSample result = a;
        result.value = lerp(axis.step, a.value, b.value);
        if constexpr (order == NoiseOrder::gradient) {
            result.x = lerp(axis.step, a.x, b.x);
            result.y = lerp(axis.step, a.y, b.y);
            result.z = lerp(axis.step, a.z, b.z);
            const Vector steep = hn::Mul(smoothStepSlopes(axis.distance[0]), hn::Sub(b.value, a.value));
            Vector& along = number == 0 ? result.x : number == 1 ? result.y : result.z;
            along = hn::Add(along, steep);
        }
        return result;
    }

    GradientAxis x_, y_, z_;
    std::uint16_t places_[8][vectorLanes];
};

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
