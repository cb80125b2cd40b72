// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/numeric/interval.h"

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

    /// Whether range() narrows with its box, as proofs along a ray need it.
    virtual bool hasRanges() const { return false; }
    /// How straight value() is: along a + b s, s from -1 to 1, it lies within `bend` of its chord, and
    /// changes by no more than `spread` where each coordinate is moved by its error.
    struct Straightness {
        double bend = Interval::infinite, spread = Interval::infinite;
    };
    /// A way through a box, which holds it with its errors.
    struct Way {
        std::array<Interval, 3> box;
        std::array<double, 3> slope, error;  ///< b, and the errors, which are not negative
    };
    /// Infinite where nothing is known. The box must be finite and hold numbers alone.
    virtual Straightness straightness(const Way&) const { return {}; }
    /// Bounds of value() in a box, finite and with numbers throughout; in any other low() and high().
    Interval range(const std::array<Interval, 3>& box) const;

  protected:
    /// The same in a box that is finite and holds numbers alone.
    virtual Interval rangeIn(const std::array<Interval, 3>&) const { return {low(), high(), false}; }
};

}  // namespace isoscope
