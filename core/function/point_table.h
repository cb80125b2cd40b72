// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>

namespace isoscope {

struct Interval;

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
    /// How straight value() is along a way.
    struct Straightness {
        static constexpr double unknown = std::numeric_limits<double>::infinity();
        double bend = unknown, spread = unknown;
    };
    /// Along a + b s, s from -1 to 1, value() lies within `bend` of its chord, and changes by no more than
    /// `spread` where each coordinate is moved by its error. `slope` is b, `errors` are not negative, and the
    /// box, which must be finite and hold numbers alone, holds all of that.
    virtual Straightness straightness(const std::array<Interval, 3>&, const std::array<double, 3>& /*slope*/,
                                      const std::array<double, 3>& /*errors*/) const {
        return {};
    }
    /// Bounds of value() in a box, finite and with numbers throughout; in any other low() and high().
    Interval range(const std::array<Interval, 3>& box) const;

  protected:
    /// The same in a box that is finite and holds numbers alone.
    virtual Interval rangeIn(const std::array<Interval, 3>&) const;
};

}  // namespace isoscope
