// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/function/point_table.h"
#include "core/numeric/interval.h"

namespace isoscope {

/// How the samples of a grid are joined: each stands for its cell, or Catmull and Rom's spline or straight
/// lines lead from one to the next.
enum class SampleJoin { none, linear, cubic };

/// One axis of a grid of samples.
struct SampleAxis {
    int size = 1;
    double firstAt = 0;  ///< coordinate of the first sample, the next is 1 further; a cell always begins at 0
    /// Beyond its ends the grid begins anew; else its last samples go on.
    bool wrapsBelow = false, wrapsAbove = false;
};

/// Bounds of what is joined of the samples of a grid with up to three axes (the others have one sample): by a
/// pyramid of their least and greatest values. Immutable.
class SampleBounds {
  public:
    using Sample = std::function<double(const std::array<int, 3>&)>;

    /// `sample` is asked for places within the grid, and must outlive the bounds.
    SampleBounds(const std::array<SampleAxis, 3>& axes, SampleJoin join, Sample sample);

    /// Holds every value in a box of coordinates of the grid, whose middle has the value `middle`. Straight
    /// lines and splines leave that by no more than their slope allows, so that bounds get as narrow as the
    /// box. The box must be finite and not empty.
    Interval over(const std::array<Interval, 3>& box, double middle) const;
    /// As PointTable::straightness() in coordinates of the grid, of all that is joined within one cell, and
    /// of splines anywhere.
    PointTable::Straightness straightness(const std::array<Interval, 3>& box,
                                          const std::array<double, 3>& slope,
                                          const std::array<double, 3>& errors) const;

  private:
    struct Extent {
        float low, high;
    };
    struct Level {
        std::array<int, 3> size;
        std::vector<Extent> extents;
    };
    using Places = std::array<int, 3>;

    Extent at(std::size_t level, const Places& place) const;
    void addLevel();
    Extent between(const Places& first, const Places& last) const;
    struct Samples {
        Extent extent;
        bool oneCell;
    };
    Samples samplesOf(const std::array<Interval, 3>& box) const;
    double overshoot() const;

    std::array<SampleAxis, 3> axes_;
    SampleJoin join_;
    Sample sample_;
    std::vector<Level> levels_;  ///< each cell for 2 by 2 by 2 of the level below; the lowest are the samples
};

}  // namespace isoscope
