// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/algebra/affine_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/function/scalar_operations.h"

namespace isoscope {

namespace {

constexpr double roundings = 1e-14;
constexpr AffineForm unknownForm{0, 0, std::numeric_limits<double>::infinity()};

/// min(1, max(0, value +- reach)).
AffineForm clipped(double value, double reach) {
    const double low = std::clamp(value - reach, 0.0, 1.0), high = std::clamp(value + reach, 0.0, 1.0);
    return {(low + high) / 2, 0, (high - low) / 2 + roundings};
}

}  // namespace

AffineForm affineCrackle(std::span<const AffineForm> operands, const CrackleSettings& settings) {
    if (settings.table) {
        const double low = settings.table->low(), high = settings.table->high();
        return {low + (high - low) / 2, 0, (high - low) / 2 * (1 + roundings)};
    }
    std::array<double, 3> center;
    double reach = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const AffineForm& p = operands[k];
        if (!std::isfinite(p.e)) return unknownForm;
        center[k] = p.a;
        reach += (std::abs(p.b) + p.e) * (1 + roundings) + std::abs(p.a) * 1e-16;
    }
    const double value = evaluateOperation(Operation::crackle, center, &settings);
    if (std::isnan(value)) return unknownForm;
    // Distances in a metric of exponent 1 or more change at most as fast as the sum of the coordinates'
    // changes.
    const double steepness =
        std::abs(settings.form[0]) + std::abs(settings.form[1]) + std::abs(settings.form[2]);
    if (settings.solid || settings.metric < 1 || !(steepness * reach < 1)) return {0.5, 0, 0.5};
    return clipped(value, steepness * reach + roundings);
}

}  // namespace isoscope
