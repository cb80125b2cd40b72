// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/noise_cell.h"

#include <algorithm>
#include <limits>

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/numeric/noise_cell.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, noiseLanes>;
using Vector = hn::Vec<Tag>;

/// The noise and its derivatives, in the order of NoiseRange: value, slopes x y z, bends xx xy xz yy yz zz.
constexpr std::size_t quantities = 10;
/// Those of them that need no derivative along z, with the sources of the others.
enum Column { plain, byX, byY, byXX, byXY, byYY, columns };
using Columns = double[columns][4];
using Rows = double[4][4];

struct Extremes {
    HWY_ALIGN double low[quantities][noiseLanes];
    HWY_ALIGN double high[quantities][noiseLanes];
    HWY_ALIGN double square[noiseLanes];  ///< of the length of the gradient
};

/// Sums over x at coefficient `i` of it: the function and its derivatives along x, for each y and z.
HWY_INLINE void sumAlongX(const NoiseFactors& factors, const NoiseAxisPart& x, std::size_t i, Rows& value,
                          Rows& slope, Rows& bend) {
    for (std::size_t b = 0; b < 4; ++b)
        for (std::size_t g = 0; g < 4; ++g) {
            double v = 0, s = 0, c = 0;
            for (std::size_t a = 0; a < 4; ++a) {
                const double factor = factors[a][b][g];
                v += factor * x.value[a][i];
                s += factor * x.slope[a][i];
                c += factor * x.bend[a][i];
            }
            value[b][g] = v, slope[b][g] = s, bend[b][g] = c;
        }
}

HWY_INLINE void sumAlongY(const Rows& value, const Rows& slope, const Rows& bend, const NoiseAxisPart& y,
                          std::size_t j, Columns& to) {
    for (int g = 0; g < 4; ++g) {
        for (int c = 0; c < columns; ++c) to[c][g] = 0;
        for (std::size_t b = 0; b < 4; ++b) {
            const double v = y.value[b][j], s = y.slope[b][j], c = y.bend[b][j];
            to[plain][g] += value[b][g] * v;
            to[byX][g] += slope[b][g] * v;
            to[byY][g] += value[b][g] * s;
            to[byXX][g] += bend[b][g] * v;
            to[byXY][g] += slope[b][g] * s;
            to[byYY][g] += value[b][g] * c;
        }
    }
}

/// Takes in all coefficients of z for one pair of x and y.
HWY_INLINE void takeIn(const Columns& column, const NoiseAxisPart& z, Extremes& extremes) {
    const Tag d;
    for (std::size_t k = 0; k < z.count; k += hn::Lanes(d)) {
        Vector all[quantities];
        for (auto& v : all) v = hn::Zero(d);
        for (std::size_t g = 0; g < 4; ++g) {
            const auto value = hn::Load(d, &z.value[g][k]), slope = hn::Load(d, &z.slope[g][k]),
                       bend = hn::Load(d, &z.bend[g][k]);
            const auto add = [&](std::size_t quantity, Column c, Vector v) {
                all[quantity] = hn::MulAdd(hn::Set(d, column[c][g]), v, all[quantity]);
            };
            add(0, plain, value), add(1, byX, value), add(2, byY, value), add(3, plain, slope);
            add(4, byXX, value), add(5, byXY, value), add(6, byX, slope), add(7, byYY, value);
            add(8, byY, slope), add(9, plain, bend);
        }
        for (std::size_t q = 0; q < quantities; ++q) {
            hn::Store(hn::Min(all[q], hn::Load(d, extremes.low[q] + k)), d, extremes.low[q] + k);
            hn::Store(hn::Max(all[q], hn::Load(d, extremes.high[q] + k)), d, extremes.high[q] + k);
        }
        const auto square = hn::MulAdd(all[1], all[1], hn::MulAdd(all[2], all[2], hn::Mul(all[3], all[3])));
        hn::Store(hn::Max(square, hn::Load(d, extremes.square + k)), d, extremes.square + k);
    }
}

void includeCell(const NoiseFactors& factors, const std::array<const NoiseAxisPart*, 3>& parts,
                 NoiseRange& range) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Extremes extremes;
    for (std::size_t k = 0; k < noiseLanes; ++k) {
        extremes.square[k] = 0;
        for (std::size_t q = 0; q < quantities; ++q)
            extremes.low[q][k] = infinite, extremes.high[q][k] = -infinite;
    }
    for (std::size_t i = 0; i < parts[0]->count; ++i) {
        Rows value, slope, bend;
        sumAlongX(factors, *parts[0], i, value, slope, bend);
        for (std::size_t j = 0; j < parts[1]->count; ++j) {
            Columns column;
            sumAlongY(value, slope, bend, *parts[1], j, column);
            takeIn(column, *parts[2], extremes);
        }
    }
    for (std::size_t q = 0; q < quantities; ++q) {
        SlopeRange& to = q == 0 ? range.value : q < 4 ? range.slope[q - 1] : range.bend[q - 4];
        for (std::size_t k = 0; k < noiseLanes; ++k) to = hull(to, {extremes.low[q][k], extremes.high[q][k]});
    }
    for (const double square : extremes.square) range.steepness = std::max(range.steepness, square);
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

namespace {

constexpr std::size_t order = NoiseAxisPart::coefficients;
using Powers = std::array<double, order>;

/// p(low + s) as a polynomial in s.
Powers shifted(Powers power, double low) {
    for (std::size_t done = 0; done < order - 1; ++done)
        for (std::size_t k = order - 1; k-- > done;) power[k] += low * power[k + 1];
    return power;
}

Powers derivative(const Powers& power) {
    Powers result{};
    for (std::size_t n = 1; n < order; ++n) result[n - 1] = static_cast<double>(n) * power[n];
    return result;
}

/// Bernstein coefficients on [0, width] of a polynomial given by its powers.
NoiseCoefficients bernstein(const Powers& power, double width) {
    constexpr double share[order][order] = {{1, 0, 0, 0, 0},
                                            {1, 1. / 4, 0, 0, 0},
                                            {1, 2. / 4, 1. / 6, 0, 0},
                                            {1, 3. / 4, 3. / 6, 1. / 4, 0},
                                            {1, 1, 1, 1, 1}};
    Powers scaled = power;
    double scale = 1;
    for (double& coefficient : scaled) {
        coefficient *= scale;
        scale *= width;
    }
    NoiseCoefficients result;
    for (std::size_t j = 0; j < order; ++j) {
        result[j] = 0;
        for (std::size_t k = 0; k <= j; ++k) result[j] += share[j][k] * scaled[k];
    }
    for (std::size_t j = order; j < noiseLanes; ++j) result[j] = result[order - 1];
    return result;
}

}  // namespace

NoiseAxisPart::NoiseAxisPart(std::pair<double, double> part) {
    // S = 3t^2 - 2t^3; 1 - S; (1 - S) t; S (t - 1).
    constexpr Powers functions[4] = {{1, 0, -3, 2, 0}, {0, 0, 3, -2, 0}, {0, 1, 0, -3, 2}, {0, 0, -3, 5, -2}};
    const double width = part.second - part.first;
    if (width == 0) count = 1;
    for (std::size_t k = 0; k < 4; ++k) {
        const Powers here = shifted(functions[k], part.first), slopes = derivative(here);
        value[k] = bernstein(here, width);
        slope[k] = bernstein(slopes, width);
        bend[k] = bernstein(derivative(slopes), width);
    }
}

HWY_EXPORT(includeCell);

void includeNoiseCell(const NoiseFactors& factors, const std::array<const NoiseAxisPart*, 3>& parts,
                      NoiseRange& range) {
    HWY_DYNAMIC_DISPATCH(includeCell)(factors, parts, range);
}

}  // namespace isoscope
#endif
