// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/evaluate/batch_evaluator.h"
#include "core/evaluate/gradient_evaluator.h"
#include "core/roots/first_roots.h"
#include "core/roots/plain_march.h"
#include "core/roots/root_settings.h"

namespace isoscope {

/// Moves crossings from somewhere in their interval to where the function is 0, and finds their normals, many
/// side by side: a step of Newton's with the slope of the enclosure, then steps with the exact slope, which
/// comes with the gradient. The last of these steps is at most a hundredth of the accuracy, and what it
/// leaves is its square; the normal is that of the place where it began. Where the enclosure shows that the
/// function is all but straight, one exact step from the middle of the interval does the same. Roots never
/// leave their interval.
class NewtonPolish {
  public:
    /// The last step of a root is no longer than this part of the accuracy.
    static constexpr double lastStep = 0.01;
    /// Crossings in intervals no longer than this part of the accuracy that bend no more than `straight` take
    /// a single step. From the middle of an interval of width w = bend * h, h the length of the piece, it
    /// leaves at most w * bend^2: with an enclosure's error of e the second derivative is about 16 e / h^2 or
    /// less, in the scale where the slope is 2 e / (bend * h).
    static constexpr double narrow = 0.1;
    static constexpr double straight = 0.01;

    /// The references must outlive the polish.
    NewtonPolish(BatchEvaluator& points, GradientEvaluator& gradients, const RootSettings& settings)
        : points_(points), gradients_(gradients), settings_(settings) {}

    /// A crossing that does not settle (a kink, a jump, no gradient).
    struct Unsettled {
        std::size_t line;
        double low, high, steepness;
    };

    /// Puts into roots.crossings what settles; `crossings` is used up. By `shortTape`, if there is one, which
    /// has to hold in the intervals.
    void run(PlainMarch::Crossings& crossings, FirstRoots& roots, const ShortTape* shortTape = nullptr);
    const std::vector<Unsettled>& unsettled() const { return unsettled_; }

    /// Points of the crossings at hand.
    enum Column : std::size_t { t, x, y, z, columnCount };
    using Columns = ColumnTable<columnCount>;

  private:
    void settleStraight(PlainMarch::Crossings& crossings, FirstRoots& roots);
    void start(PlainMarch::Crossings& crossings);
    void refine(PlainMarch::Crossings& crossings, double longest, FirstRoots& roots);

    BatchEvaluator& points_;
    GradientEvaluator& gradients_;
    const RootSettings& settings_;
    const ShortTape* shortTape_ = nullptr;
    PlainMarch::Crossings straight_;
    Columns columns_;
    AlignedColumn values_;
    std::vector<Unsettled> unsettled_;
};

}  // namespace isoscope
