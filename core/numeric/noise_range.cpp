// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/noise_range.h"

#include "core/numeric/noise.h"
#include "core/numeric/noise_bounds.h"
#include "core/numeric/noise_place.h"

namespace isoscope {

namespace {

constexpr int order = 5;  ///< Bernstein coefficients of degree 4
using Bernstein = std::array<double, order>;

/// More than what rounding changes in coefficients of this size.
constexpr double slack = 1e-11;

/// Bernstein coefficients on [0, 1] of a polynomial given by its powers.
Bernstein fromPowers(const Bernstein& power) {
    constexpr double choose[order][order] = {
        {1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}};
    Bernstein result{};
    for (int j = 0; j < order; ++j)
        for (int k = 0; k <= j; ++k) result[j] += choose[j][k] / choose[4][k] * power[k];
    return result;
}

/// p(low + width s) as a polynomial in s.
Bernstein substituted(Bernstein power, double low, double width) {
    for (int done = 0; done < order - 1; ++done)
        for (int k = order - 2; k >= done; --k) power[k] += low * power[k + 1];
    double scale = 1;
    for (double& coefficient : power) {
        coefficient *= scale;
        scale *= width;
    }
    return power;
}

/// The functions along one axis of a cell, over a part of it: the weights of both ends, and those times the
/// distance from the end; with their derivatives.
struct AxisPart {
    std::array<Bernstein, 4> value, slope;

    AxisPart(double low, double high) {
        // S = 3t^2 - 2t^3; 1 - S; (1 - S) t; S (t - 1).
        constexpr Bernstein powers[4] = {
            {1, 0, -3, 2, 0}, {0, 0, 3, -2, 0}, {0, 1, 0, -3, 2}, {0, 0, -3, 5, -2}};
        for (int k = 0; k < 4; ++k) {
            Bernstein derivative{};
            for (int n = 1; n < order; ++n) derivative[n - 1] = n * powers[k][n];
            value[k] = fromPowers(substituted(powers[k], low, high - low));
            slope[k] = fromPowers(substituted(derivative, low, high - low));
        }
    }
};

/// Factors of products of axis functions: index 0 and 1 the weights, 2 and 3 the weights times distance.
using Factors = std::array<std::array<std::array<double, 4>, 4>, 4>;

/// What the noise has at the corner: value, and slopes along the axes.
void setCorner(Factors& f, int a, int b, int g, double value, const double* slopes) {
    f[a][b][g] = value;
    f[a + 2][b][g] = slopes[0];
    f[a][b + 2][g] = slopes[1];
    f[a][b][g + 2] = slopes[2];
}

Factors latticeFactors(int component, const std::array<double, 3>& cell) {
    const auto& hash = latticeHash();
    const auto& values = latticeValues();
    const LatticePlace x(cell[0] + 0.5), y(cell[1] + 0.5), z(cell[2] + 0.5);
    Factors factors{};
    for (unsigned a = 0; a < 2; ++a)
        for (unsigned b = 0; b < 2; ++b)
            for (unsigned g = 0; g < 2; ++g) {
                const unsigned row = hash[hash[x.index + a] ^ (y.index + b)];
                const double* entry = &values[hash[row ^ (z.index + g)] & 255u] + 4 * component;
                setCorner(factors, a, b, g, entry[0] * 0.5, entry + 1);
            }
    return factors;
}

Factors gradientFactors(const std::array<double, 3>& cell) {
    const GradientNoiseTables& tables = gradientNoiseTables();
    const auto index = [](double base, unsigned side) {
        return ((static_cast<unsigned>(static_cast<std::int64_t>(base)) & 2047u) + side);
    };
    Factors factors{};
    for (unsigned a = 0; a < 2; ++a)
        for (unsigned b = 0; b < 2; ++b)
            for (unsigned g = 0; g < 2; ++g) {
                const unsigned row = tables.hash[tables.hash[index(cell[0], a)] + index(cell[1], b)];
                setCorner(factors, a, b, g, 0, tables.gradients[(row + index(cell[2], g)) & 2047u].data());
            }
    return factors;
}

/// Coefficients of value and derivatives for one pair of positions along x and y.
struct Column {
    std::array<double, 4> value{}, alongX{}, alongY{};
};

void include(NoiseRange& range, const std::array<double, 4>& coefficients) {
    range.value = hull(range.value, {coefficients[0], coefficients[0]});
    double length = 0;
    for (int k = 0; k < 3; ++k) {
        const double slope = coefficients[k + 1];
        range.slope[k] = hull(range.slope[k], {slope, slope});
        length += slope * slope;
    }
    // Of the square, until the end.
    range.steepness = std::max(range.steepness, length);
}

/// Adds the coefficients of one cell.
void includeCell(const Factors& factors, const std::array<AxisPart, 3>& parts, NoiseRange& range) {
    const AxisPart &px = parts[0], &py = parts[1], &pz = parts[2];
    for (int i = 0; i < order; ++i) {
        std::array<std::array<double, 4>, 4> value{}, slope{};
        for (int b = 0; b < 4; ++b)
            for (int g = 0; g < 4; ++g)
                for (int a = 0; a < 4; ++a) {
                    value[b][g] += factors[a][b][g] * px.value[a][i];
                    slope[b][g] += factors[a][b][g] * px.slope[a][i];
                }
        for (int j = 0; j < order; ++j) {
            Column column;
            for (int g = 0; g < 4; ++g)
                for (int b = 0; b < 4; ++b) {
                    column.value[g] += value[b][g] * py.value[b][j];
                    column.alongX[g] += slope[b][g] * py.value[b][j];
                    column.alongY[g] += value[b][g] * py.slope[b][j];
                }
            for (int k = 0; k < order; ++k) {
                std::array<double, 4> c{};
                for (int g = 0; g < 4; ++g) {
                    c[0] += column.value[g] * pz.value[g][k];
                    c[1] += column.alongX[g] * pz.value[g][k];
                    c[2] += column.alongY[g] * pz.value[g][k];
                    c[3] += column.value[g] * pz.slope[g][k];
                }
                include(range, c);
            }
        }
    }
}

NoiseRange everywhere(const NoiseBounds& bounds) {
    const SlopeRange slope = SlopeRange::within(bounds.slope);
    return {{bounds.low, bounds.high}, {slope, slope, slope}, bounds.lipschitz};
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

}  // namespace

NoiseRange noiseRange(NoiseKind kind, const std::array<double, 3>& givenLow,
                      const std::array<double, 3>& givenHigh) {
    constexpr double cellLimit = 12;
    const bool isGradient = kind == NoiseKind::gradient;
    const NoiseBounds& bounds = isGradient ? gradientNoiseBounds : latticeNoiseBounds;
    std::array<double, 3> low = givenLow, high = givenHigh;
    if (isGradient)
        for (int k = 0; k < 3; ++k) {
            // The shift of docs/povray/noise.md, section 5; rounding it moves the place by less than 2^-28.
            low[k] += 10000000.023157213 - 4e-9;
            high[k] += 10000000.023157213 + 4e-9;
        }
    const CellSpan spans[3] = {{low[0], high[0]}, {low[1], high[1]}, {low[2], high[2]}};
    if (!(spans[0].count * spans[1].count * spans[2].count <= cellLimit)) return everywhere(bounds);

    constexpr double infinite = std::numeric_limits<double>::infinity();
    const SlopeRange nothing{infinite, -infinite};
    NoiseRange range{nothing, {nothing, nothing, nothing}, 0};
    for (int i = 0; i < spans[0].count; ++i)
        for (int j = 0; j < spans[1].count; ++j)
            for (int k = 0; k < spans[2].count; ++k) {
                const auto x = spans[0].part(i, low[0], high[0]), y = spans[1].part(j, low[1], high[1]),
                           z = spans[2].part(k, low[2], high[2]);
                const std::array<double, 3> cell{spans[0].first + i, spans[1].first + j, spans[2].first + k};
                const std::array parts{AxisPart(x.first, x.second), AxisPart(y.first, y.second),
                                       AxisPart(z.first, z.second)};
                includeCell(isGradient ? gradientFactors(cell) : latticeFactors(static_cast<int>(kind), cell),
                            parts, range);
            }
    const SlopeRange rounding = SlopeRange::within(slack);
    range.value = meet(range.value + rounding, {bounds.low, bounds.high});
    for (SlopeRange& slope : range.slope) slope = meet(slope + rounding, SlopeRange::within(bounds.slope));
    range.steepness = std::min(bounds.lipschitz, std::sqrt(range.steepness) + slack);
    return range;
}

}  // namespace isoscope
