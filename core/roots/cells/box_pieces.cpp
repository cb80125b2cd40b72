// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/cells/box_pieces.h"

#include <cmath>
#include <span>

#include "core/evaluate/prepared_function.h"

namespace isoscope {

namespace {

/// The sign that all values have, 0 where there is none.
double signOf(const Interval& values, const RootSettings& settings) {
    // More than values of points are off by their roundings.
    const double margin =
        1e-15 * (std::abs(settings.threshold) + std::abs(values.low) + std::abs(values.high));
    if (values.empty() || !std::isfinite(margin)) return 0;
    const double above = settings.positivePolarity ? -1 : 1;
    if (values.low - margin > settings.threshold) return above;
    return values.high + margin < settings.threshold ? -above : 0;
}

}  // namespace

BoxPieces::BoxPieces(const PreparedFunction& function, const RootSettings& settings)
    : settings_(settings),
      boxes_(function.shared_from_this()),
      simplifier_(function.links()),
      levels_(function.links().levels(function.uniforms(), settings.threshold)),
      base_(&function.links().whole()) {}

void BoxPieces::setBase(const SimplifiedTape& base) {
    base_ = &base;
    simplifier_.setBase(base_);
}

void BoxPieces::place(const glm::dvec3& center, const glm::dvec3& halfWidth, std::size_t lane) {
    for (int axis = 0; axis < 3; ++axis) {
        const double reach = (1 + 1e-6) * halfWidth[axis] + 1e-13 * std::abs(center[axis]);
        lanes_.low[static_cast<std::size_t>(axis)][lane] = center[axis] - reach;
        lanes_.high[static_cast<std::size_t>(axis)][lane] = center[axis] + reach;
    }
}

void BoxPieces::enclose(std::size_t count) {
    std::array<Interval, batchLanes> values;
    work_ += count * base_->instructions.size();
    boxes_.evaluateChoices(lanes_, *base_, {levels_, simplifier_.levelNumbers()},
                           std::span(values).first(count), choices_);
    for (std::size_t lane = 0; lane < count; ++lane) {
        const double sign = signOf(values[lane], settings_);
        signs_[lane] = values[lane].maybeUndefined ? 0 : sign;
        isOutside_[lane] = values[lane].empty() || sign > 0;
    }
}

}  // namespace isoscope
