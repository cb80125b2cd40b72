// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/noise_range.h"

#include <span>
#include <vector>

#include "core/numeric/noise.h"
#include "core/numeric/noise_bounds.h"
#include "core/numeric/noise_cell.h"
#include "core/numeric/noise_place.h"

namespace isoscope {

namespace {

/// More than what rounding changes in coefficients of this size.
constexpr double slack = 1e-11;

/// What the noise has at the corner: value, and slopes along the axes.
void setCorner(NoiseFactors& f, std::size_t a, std::size_t b, std::size_t g, double value,
               const double* slopes) {
    f[a][b][g] = value;
    f[a + 2][b][g] = slopes[0];
    f[a][b + 2][g] = slopes[1];
    f[a][b][g + 2] = slopes[2];
}

NoiseFactors latticeFactors(int component, const std::array<double, 3>& cell) {
    const auto& hash = latticeHash();
    const auto& values = latticeValues();
    const LatticePlace x(cell[0] + 0.5), y(cell[1] + 0.5), z(cell[2] + 0.5);
    NoiseFactors factors{};
    for (unsigned a = 0; a < 2; ++a)
        for (unsigned b = 0; b < 2; ++b)
            for (unsigned g = 0; g < 2; ++g) {
                const unsigned row = hash[hash[x.index + a] ^ (y.index + b)];
                const double* entry = &values[hash[row ^ (z.index + g)] & 255u] + 4 * component;
                setCorner(factors, a, b, g, entry[0] * 0.5, entry + 1);
            }
    return factors;
}

NoiseFactors gradientFactors(const std::array<double, 3>& cell) {
    const GradientNoiseTables& tables = gradientNoiseTables();
    const auto index = [](double base, unsigned side) {
        return ((static_cast<unsigned>(static_cast<std::int64_t>(base)) & 2047u) + side);
    };
    NoiseFactors factors{};
    for (unsigned a = 0; a < 2; ++a)
        for (unsigned b = 0; b < 2; ++b)
            for (unsigned g = 0; g < 2; ++g) {
                const unsigned row = tables.hash[tables.hash[index(cell[0], a)] + index(cell[1], b)];
                setCorner(factors, a, b, g, 0, tables.gradients[(row + index(cell[2], g)) & 2047u].data());
            }
    return factors;
}

NoiseRange everywhere(const NoiseBounds& bounds) {
    const SlopeRange slope = SlopeRange::within(bounds.slope);
    const SlopeRange bend = SlopeRange::within(bounds.bend), twist = SlopeRange::within(bounds.twist);
    return {{bounds.low, bounds.high},
            {slope, slope, slope},
            bounds.lipschitz,
            {bend, twist, twist, bend, twist, bend}};
}

/// The cells that an interval meets.
struct CellSpan {
    double first, count;

    CellSpan(double low, double high)
        : first(std::floor(low)), count(std::max(1.0, std::ceil(high) - std::floor(low))) {}
    /// The part of cell `k` in it, as places in the cell.
    std::pair<double, double> part(int k, double low, double high) const {
        return {std::clamp(low - (first + k), 0.0, 1.0), std::clamp(high - (first + k), 0.0, 1.0)};
    }
};

/// The parts of the cells that a box meets, in their order along each axis: cells in a row share them.
struct BoxParts {
    bool complete = false;
    std::array<double, 3> low{}, high{};
    std::array<std::vector<NoiseAxisPart>, 3> axes;
};

/// Of the box that the thread asked about last they are kept: the components of vector noise ask for the same
/// one after the other.
const BoxParts& partsOf(const std::array<double, 3>& low, const std::array<double, 3>& high,
                        std::span<const CellSpan, 3> spans) {
    thread_local BoxParts kept;
    if (kept.complete && kept.low == low && kept.high == high) return kept;
    kept.complete = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        kept.axes[axis].clear();
        for (int i = 0; i < spans[axis].count; ++i)
            kept.axes[axis].emplace_back(spans[axis].part(i, low[axis], high[axis]));
    }
    kept.low = low;
    kept.high = high;
    kept.complete = true;
    return kept;
}

}  // namespace

NoiseRange noiseRange(NoiseKind kind, const std::array<double, 3>& givenLow,
                      const std::array<double, 3>& givenHigh) {
    constexpr double cellLimit = 12;
    const bool isGradient = kind == NoiseKind::gradient;
    const NoiseBounds& bounds = isGradient ? gradientNoiseBounds : latticeNoiseBounds;
    std::array<double, 3> low = givenLow, high = givenHigh;
    if (isGradient)
        for (std::size_t k = 0; k < 3; ++k) {
            // The shift of docs/povray/noise.md, section 5; rounding it moves the place by less than 2^-28.
            low[k] += 10000000.023157213 - 4e-9;
            high[k] += 10000000.023157213 + 4e-9;
        }
    const CellSpan spans[3] = {{low[0], high[0]}, {low[1], high[1]}, {low[2], high[2]}};
    if (!(spans[0].count * spans[1].count * spans[2].count <= cellLimit)) return everywhere(bounds);

    constexpr double infinite = std::numeric_limits<double>::infinity();
    const SlopeRange nothing{infinite, -infinite};
    NoiseRange range{nothing, {nothing, nothing, nothing}, 0, {}};
    range.bend.fill(nothing);
    const auto& axes = partsOf(low, high, spans).axes;
    const auto cellOf = [&](std::size_t axis, std::size_t number) {
        return spans[axis].first + static_cast<double>(number);
    };
    for (std::size_t i = 0; i < axes[0].size(); ++i)
        for (std::size_t j = 0; j < axes[1].size(); ++j)
            for (std::size_t k = 0; k < axes[2].size(); ++k) {
                const std::array cell{cellOf(0, i), cellOf(1, j), cellOf(2, k)};
                const std::array parts{&axes[0][i], &axes[1][j], &axes[2][k]};
                includeNoiseCell(
                    isGradient ? gradientFactors(cell) : latticeFactors(static_cast<int>(kind), cell), parts,
                    range);
            }
    const SlopeRange rounding = SlopeRange::within(slack);
    range.value = meet(range.value + rounding, {bounds.low, bounds.high});
    for (SlopeRange& slope : range.slope) slope = meet(slope + rounding, SlopeRange::within(bounds.slope));
    const NoiseRange limits = everywhere(bounds);
    for (std::size_t k = 0; k < range.bend.size(); ++k)
        range.bend[k] = meet(range.bend[k] + rounding, limits.bend[k]);
    range.steepness = std::min(bounds.lipschitz, std::sqrt(range.steepness) + slack);
    return range;
}

}  // namespace isoscope
