// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace isoscope {

/// A number for every point of space that no formula gives: a channel of an image, a file of densities,
/// whether the point lies in an object. Immutable; shared by all threads, which may ask at the same time.
class PointTable {
  public:
    virtual ~PointTable() = default;

    /// Between low() and high(); never NaN, for any point.
    virtual double value(const std::array<double, 3>& point) const = 0;

    /// Bounds of value() over all of space, which enclosures rely on: finite, and the same for the table's
    /// life.
    virtual double low() const { return 0; }
    virtual double high() const { return 1; }
};

}  // namespace isoscope
