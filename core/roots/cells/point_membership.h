// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <optional>

#include "core/evaluate/point_evaluator.h"
#include "core/roots/cells/cell_tree.h"
#include "core/roots/root_settings.h"

namespace isoscope {

class PreparedFunction;

/// Whether points are inside an isosurface, its container aside, by the value of the function there. Of
/// functions full of choices (unions of many parts) only what decides near a point is evaluated, once more
/// than a few points were asked for: a CellTree over settings.region. The answer is that of the whole
/// function, whatever was asked before. Not for several threads at once.
class PointMembership {
  public:
    /// `settings` are made usable() first.
    PointMembership(std::shared_ptr<const PreparedFunction> function, const RootSettings& settings);
    // The cells refer to the settings.
    PointMembership(const PointMembership&) = delete;
    PointMembership& operator=(const PointMembership&) = delete;

    /// Also of points on the surface, and of those where the function has no value.
    bool isInside(const glm::dvec3& point);

    /// What has been done so far, as so many instructions for one point or box.
    std::uint64_t work() const { return work_ + (cells_ ? cells_->work() : 0); }

  private:
    RootSettings settings_;
    std::shared_ptr<const PreparedFunction> function_;
    PointEvaluator points_;
    std::optional<CellTree> cells_;  ///< where they can be of use
    std::uint64_t work_ = 0;
};

}  // namespace isoscope
