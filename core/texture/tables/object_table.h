// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "core/function/point_table.h"
#include "core/shapes/shape.h"

namespace isoscope {

/// Whether points lie in an object: 1 inside, 0 outside.
class ObjectTable : public PointTable {
  public:
    /// `parameters` are the values of the scene's slots, for isosurfaces in the object.
    ObjectTable(ShapePointer shape, std::shared_ptr<const std::vector<double>> parameters)
        : shape_(std::move(shape)), parameters_(std::move(parameters)) {}

    double value(const std::array<double, 3>& point) const override;

  private:
    ShapePointer shape_;
    std::shared_ptr<const std::vector<double>> parameters_;
    /// Contexts that earlier questions have left, for reuse: what shapes keep in them takes long to make.
    mutable std::mutex mutex_;
    mutable std::vector<std::unique_ptr<TraceContext>> idle_;
};

}  // namespace isoscope
