// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/shapes/bounds.h"
#include "core/shapes/rays/ray.h"

namespace isoscope {

/// A ray made ready for many slab tests (Kay and Kajiya 1986): divided once, so that each test multiplies.
/// No box is missed that Bounds::clip would let through.
class SlabRay {
  public:
    explicit SlabRay(const Ray& ray) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<std::size_t>(axis);
            origin_[k] = ray.origin[axis];
            inverse_[k] = 1 / ray.direction[axis];
            backwards_[k] = std::signbit(ray.direction[axis]);
            usable_ &= std::isfinite(ray.origin[axis]) && std::isfinite(ray.direction[axis]);
        }
    }

    /// Where the ray enters the box between the corners `low` and `high` (x, y, z), grown by what rounding
    /// may hide; infinite when it misses the box within the interval, or is no ray.
    double enter(const double* low, const double* high, RayInterval interval) const {
        constexpr double room = 1e-12;
        double near = interval.near, far = interval.far;
        for (std::size_t k = 0; k < 3; ++k) {
            const double in = ((backwards_[k] ? high : low)[k] - origin_[k]) * inverse_[k];
            const double out = ((backwards_[k] ? low : high)[k] - origin_[k]) * inverse_[k];
            // Both comparisons are false for 0 times infinity, on the very wall of a flat slab, which is no
            // reason to miss the box.
            near = in > near ? in : near;
            far = out < far ? out : far;
        }
        near -= room * std::abs(near);
        return usable_ && near <= far + room * std::abs(far) ? near : std::numeric_limits<double>::infinity();
    }

    /// False only when nothing of the box lies on the ray between t = 0 and `farthest`.
    bool mayMeet(const Bounds& box, double farthest) const {
        return enter(&box.low.x, &box.high.x, {0, farthest}) < std::numeric_limits<double>::infinity();
    }

  private:
    std::array<double, 3> origin_, inverse_;
    std::array<bool, 3> backwards_;
    bool usable_ = true;
};

}  // namespace isoscope
