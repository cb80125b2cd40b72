// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/affine_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/function/scalar_operations.h"
#include "core/numeric/noise.h"
#include "core/numeric/noise_bounds.h"
#include "core/numeric/noise_gradient.h"

namespace isoscope {

namespace {

constexpr double roundings = 1e-14;
constexpr AffineForm unknownForm{0, 0, std::numeric_limits<double>::infinity()};

struct Place {
    std::array<double, 3> center;
    std::array<double, 3> slope;
    std::array<double, 3> error;
    std::array<double, 3> reach;  ///< |slope| + error

    explicit Place(std::span<const AffineForm> p) {
        for (std::size_t k = 0; k < 3; ++k) {
            center[k] = p[k].a;
            slope[k] = p[k].b;
            error[k] = p[k].e;
            reach[k] = (std::abs(p[k].b) + p[k].e) * (1 + roundings) + std::abs(p[k].a) * 1e-16;
        }
    }
    /// Noise takes coordinates beyond its lattice as 0.
    bool onLattice() const {
        for (std::size_t k = 0; k < 3; ++k)
            if (!(std::abs(center[k]) + reach[k] < 2147483647.0)) return false;
        return true;
    }
};

/// N + slope along the ray +- what second derivatives can add, or the first-derivative bound when that is
/// narrower.
AffineForm developed(const Place& p, const NoiseGradient& noise, const NoiseBounds& bounds,
                     double valueError) {
    double along = 0, error = 0, sum = 0, squares = 0;
    for (int k = 0; k < 3; ++k) {
        along += noise.gradient[k] * p.slope[k];
        error += std::abs(noise.gradient[k]) * p.error[k];
        sum += p.reach[k];
        squares += p.reach[k] * p.reach[k];
    }
    const double mixed = sum * sum - squares;
    const double bent = error + 0.5 * (bounds.bend * squares + bounds.twist * mixed);
    const double rounding = roundings * (1 + bounds.slope * sum) + valueError;
    const double flat = bounds.slope * sum;
    // A slope is worth its name when it leaves open half of what the bound on the slope does.
    if (!(bent <= 0.5 * flat)) return {noise.value, 0, flat * (1 + roundings) + rounding};
    return {noise.value, along, bent * (1 + roundings) + rounding};
}

/// min(1, max(0, p)); only the bounds matter, so a form that leaves [0, 1] on one side is moved inside.
AffineForm clipped(const AffineForm& p) {
    const double reach = (std::abs(p.b) + p.e) * (1 + roundings);
    if (p.a - reach >= 0 && p.a + reach <= 1) return p;
    if (p.a - reach >= 1) return {1, 0, 0};
    if (p.a + reach <= 0) return {0, 0, 0};
    const double low = std::clamp(p.a - reach, 0.0, 1.0), high = std::clamp(p.a + reach, 0.0, 1.0);
    return {(low + high) / 2, 0, (high - low) / 2 + roundings};
}

AffineForm scaled(const AffineForm& p, double factor, double offset) {
    return {p.a * factor + offset, p.b * factor, p.e * std::abs(factor) * (1 + roundings) + roundings};
}

AffineForm noiseForm(std::span<const AffineForm> operands) {
    constexpr AffineForm anywhere{0.5, 0, 0.5};
    const Place place(operands.subspan(1));
    const AffineForm& generator = operands[0];
    const bool fixed = generator.b == 0 && generator.e == 0;
    for (const AffineForm& operand : operands)
        if (!std::isfinite(operand.e)) return anywhere;
    if (!fixed || !place.onLattice()) return anywhere;
    const auto [x, y, z] = place.center;
    const int number = noiseGeneratorNumber(generator.a);
    if (number == 3) {
        // Positions are rounded to 2^-29.
        const double quantised = 3 * gradientNoiseBounds.slope * 2e-9;
        const AffineForm raw =
            developed(place, gradientNoiseWithGradient(x, y, z), gradientNoiseBounds, quantised);
        return clipped(scaled(raw, 0.5 * 1.59, 0.5 * 0.985));
    }
    const AffineForm raw = developed(place, latticeNoiseWithGradient(x, y, z), latticeNoiseBounds, 0);
    if (number == 2) return clipped(scaled(raw, 0.48985582, 1.05242 * 0.48985582));
    return clipped(scaled(raw, 1, 0.5));
}

AffineForm vectorNoiseForm(std::size_t component, std::span<const AffineForm> operands) {
    constexpr AffineForm anywhere{0, 0, vectorNoiseLimit};
    for (const AffineForm& operand : operands)
        if (!std::isfinite(operand.e)) return anywhere;
    const Place place(operands);
    if (!place.onLattice()) return anywhere;
    const auto [x, y, z] = place.center;
    return developed(place, vectorNoiseWithGradient(x, y, z)[component], latticeNoiseBounds, 0);
}

AffineForm crackleForm(std::span<const AffineForm> operands, const CrackleSettings& settings) {
    for (const AffineForm& operand : operands)
        if (!std::isfinite(operand.e)) return unknownForm;
    const Place place(operands);
    const double value = evaluateOperation(Operation::crackle, place.center, &settings);
    if (std::isnan(value)) return unknownForm;
    // Distances in a metric of exponent 1 or more change at most as fast as the sum of the coordinates'
    // changes.
    const double steepness =
        std::abs(settings.form[0]) + std::abs(settings.form[1]) + std::abs(settings.form[2]);
    const double reach = place.reach[0] + place.reach[1] + place.reach[2];
    if (settings.solid || settings.metric < 1 || !(steepness * reach < 1)) return {0.5, 0, 0.5};
    return clipped({value, 0, steepness * reach + roundings});
}

}  // namespace

AffineForm affineNoise(Operation operation, std::span<const AffineForm> operands,
                       const CrackleSettings* crackle) {
    switch (operation) {
        case Operation::noise:
            return noiseForm(operands);
        case Operation::noiseGradientX:
            return vectorNoiseForm(0, operands);
        case Operation::noiseGradientY:
            return vectorNoiseForm(1, operands);
        case Operation::noiseGradientZ:
            return vectorNoiseForm(2, operands);
        case Operation::crackle:
            return crackleForm(operands, *crackle);
        default:
            return unknownForm;
    }
}

}  // namespace isoscope
