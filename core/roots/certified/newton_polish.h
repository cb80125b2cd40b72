// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/evaluate/gradient_evaluator.h"
#include "core/roots/certified/march_kernel.h"
#include "core/roots/first_roots.h"
#include "core/roots/root_settings.h"

namespace isoscope {

/// Moves crossings from somewhere in their interval to where the function is 0, and finds their normals, many
/// side by side: by steps of Newton's with the exact slope, which comes with the gradient. The first begins
/// in the middle of the interval, where the enclosure's straight line is 0. The last is so short that it
/// leaves next to nothing; the normal is that of the place where it began. Roots never leave their interval.
class NewtonPolish {
  public:
    /// A step no longer than this part of the accuracy is the last one: what it leaves is about its square.
    static constexpr double lastStep = 0.01;
    /// Where the enclosure shows that the function hardly bends, steps up to `longestStep` are the last ones
    /// as long as they leave no more than `leftover`, in parts of the accuracy. In an interval of width
    /// w = curvatureRatio * h, h the length of the piece, an enclosure's error of e stands for a second
    /// derivative of about 16 e / h^2 or less, in the scale where the slope is 2 e / (curvatureRatio * h); so
    /// a step s leaves up to 4 s^2 curvatureRatio^2 / w.
    static constexpr double longestStep = 0.1;
    static constexpr double leftover = 1e-4;

    /// The references must outlive the polish.
    NewtonPolish(GradientEvaluator& gradients, const RootSettings& settings)
        : gradients_(gradients), settings_(settings) {}

    /// A crossing that does not settle (a kink, a jump, no gradient).
    struct Unsettled {
        std::size_t line;
        double low, high, steepness;
    };

    /// Puts into roots.crossings what settles; `crossings` is used up. By `simplifiedTape`, if there is one,
    /// which has to hold in the intervals.
    void run(MarchKernel::Crossings& crossings, FirstRoots& roots,
             const SimplifiedTape* simplifiedTape = nullptr);
    /// The crossings that run() has not settled: those of the last call only.
    const std::vector<Unsettled>& unsettled() const { return unsettled_; }

    /// Points of the crossings at hand, and how long their last steps may be.
    enum Column : std::size_t { t, x, y, z, longest, columnCount };
    using Columns = ColumnTable<columnCount>;

  private:
    void refine(MarchKernel::Crossings& crossings, FirstRoots& roots);

    GradientEvaluator& gradients_;
    const RootSettings& settings_;
    const SimplifiedTape* simplifiedTape_ = nullptr;
    Columns columns_;
    std::vector<Unsettled> unsettled_;
};

}  // namespace isoscope
