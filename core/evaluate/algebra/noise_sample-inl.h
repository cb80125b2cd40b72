// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. What the noises share: their results, and reading table rows for all
// lanes.
#if defined(ISOSCOPE_EVALUATE_NOISE_SAMPLE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_NOISE_SAMPLE_INL
#undef ISOSCOPE_EVALUATE_NOISE_SAMPLE_INL
#else
#define ISOSCOPE_EVALUATE_NOISE_SAMPLE_INL
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "core/evaluate/algebra/point_algebra-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// Noise with its derivatives in the three coordinates.
struct NoiseSample {
    Vector value, x, y, z;
};

/// Which derivatives are asked for.
enum class NoiseOrder {
    value,
    gradient,
    slopesXZ  ///< where y does not move; its derivative is told as 0
};

constexpr std::size_t vectorLanes = HWY_MAX_BYTES / sizeof(double);

/// Four numbers per lane.
struct Rows {
    Vector v[4];
};

/// table[places[i]] to table[places[i] + 3] for every lane i: whole rows are loaded and transposed, which is
/// several times faster than gathering.
template <class Place>
HWY_INLINE Rows loadRows(const double* table, const Place* places) {
    const Doubles d;
#if HWY_MAX_BYTES == 64
    const hn::Half<Doubles> half;
    const auto row = [=](int i) HWY_ATTR {
        return hn::Combine(d, hn::LoadU(half, table + places[i + 4]), hn::LoadU(half, table + places[i]));
    };
#elif HWY_MAX_BYTES == 32
    const auto row = [=](int i) HWY_ATTR { return hn::LoadU(d, table + places[i]); };
#endif
#if HWY_MAX_BYTES >= 32
    const Vector row0 = row(0), row1 = row(1), row2 = row(2), row3 = row(3);
    const Vector even01 = hn::InterleaveLower(d, row0, row1), odd01 = hn::InterleaveUpper(d, row0, row1);
    const Vector even23 = hn::InterleaveLower(d, row2, row3), odd23 = hn::InterleaveUpper(d, row2, row3);
    return {{hn::OddEvenBlocks(hn::SwapAdjacentBlocks(even23), even01),
             hn::OddEvenBlocks(hn::SwapAdjacentBlocks(odd23), odd01),
             hn::OddEvenBlocks(even23, hn::SwapAdjacentBlocks(even01)),
             hn::OddEvenBlocks(odd23, hn::SwapAdjacentBlocks(odd01))}};
#elif HWY_MAX_BYTES == 8
    const double* row = table + *places;
    return {{hn::Load(d, row), hn::Load(d, row + 1), hn::Load(d, row + 2), hn::Load(d, row + 3)}};
#else
    static_assert(HWY_MAX_BYTES == 16);
    const double *first = table + places[0], *second = table + places[1];
    const Vector low0 = hn::LoadU(d, first), low1 = hn::LoadU(d, second);
    const Vector high0 = hn::LoadU(d, first + 2), high1 = hn::LoadU(d, second + 2);
    return {{hn::InterleaveLower(d, low0, low1), hn::InterleaveUpper(d, low0, low1),
             hn::InterleaveLower(d, high0, high1), hn::InterleaveUpper(d, high0, high1)}};
#endif
}

/// Coordinates without a lattice cell (NaN too) are taken as 0.
HWY_INLINE Vector latticeCoordinates(Vector t) {
    return hn::IfThenElseZero(hn::Lt(hn::Abs(t), constantVector(2147483648.0)), t);
}

using WholeNumbers = hn::Rebind<std::int32_t, Doubles>;

/// Truncated; the numbers must fit.
HWY_INLINE hn::Vec<WholeNumbers> wholeNumbers(Vector t) {
#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128
    // Highway's own truncation would take -2147483647.5 as too large.
    return hn::DemoteTo(WholeNumbers(), hn::Trunc(t));
#else
    return hn::DemoteTo(WholeNumbers(), t);
#endif
}

/// t^2 (3 - 2t), in the order of smoothStep().
HWY_INLINE Vector smoothSteps(Vector t) {
    return hn::Mul(hn::Mul(t, t), hn::Sub(constantVector(3), hn::Mul(constantVector(2), t)));
}
HWY_INLINE Vector smoothStepSlopes(Vector t) {
    return hn::Mul(hn::Mul(constantVector(6), t), hn::Sub(constantVector(1), t));
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
