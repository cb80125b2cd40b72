// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace isoscope {

/// A function of three coordinates as root finders see it: many points at once, NaN and infinities allowed.
/// The answer for a point must not depend on the other points.
class FieldFunction {
  public:
    virtual ~FieldFunction() = default;

    /// out[i] = f(x[i], y[i], z[i]); all spans have the same length.
    virtual void values(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                        std::span<double> out) = 0;
};

}  // namespace isoscope
