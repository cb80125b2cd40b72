// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/cells/point_membership.h"

#include <span>

#include "core/evaluate/prepared_function.h"
#include "core/roots/cells/short_tapes.h"

namespace isoscope {

PointMembership::PointMembership(std::shared_ptr<const PreparedFunction> function,
                                 const RootSettings& settings)
    : settings_(settings.usable()), function_(std::move(function)), points_(function_) {
    if (!settings_.region || !ShortTapes(*function_).possible()) return;
    cells_.emplace(*function_, settings_);
    if (!cells_->beginPoints()) cells_.reset();
}

bool PointMembership::isInside(const glm::dvec3& point) {
    const auto countsAsInside = [&](double value) { return !(settings_.signedValue(value) > 0); };
    const CellTree::Cell* const cell = cells_ ? cells_->at(point) : nullptr;
    if (cell == nullptr) {
        work_ += function_->tape()->instructions().size();
        return countsAsInside(points_.evaluate(point.x, point.y, point.z));
    }
    if (cell->sign != 0) return cell->sign < 0;
    double value = 0;
    work_ += cell->tape->instructions.size();
    points_.evaluate(std::span(&point.x, 1), std::span(&point.y, 1), std::span(&point.z, 1),
                     std::span(&value, 1), *cell->tape);
    return countsAsInside(value);
}

}  // namespace isoscope
