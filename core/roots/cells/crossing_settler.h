// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/evaluate/gradient_evaluator.h"
#include "core/roots/certified/newton_polish.h"
#include "core/roots/certified/root_polish.h"
#include "core/roots/first_roots.h"

namespace isoscope {

/// Finds by point values the crossings that NewtonPolish has left, with their normals, by the tapes that hold
/// there.
class CrossingSettler {
  public:
    /// All must outlive the settler.
    CrossingSettler(const RootSettings& settings, RootPolish& polish, GradientEvaluator& gradients)
        : settings_(settings), polish_(polish), gradients_(gradients) {}

    /// The roots of these crossings of `lines`, one by one. Those that are jumps, or have no gradient, are
    /// without normals. Valid until the next call.
    std::span<const FirstRoots::Other> run(const LineColumns& lines,
                                           std::span<const NewtonPolish::Unsettled> crossings,
                                           const SimplifiedTape& tape);

  private:
    void findNormal(const LineQuery& line, const SimplifiedTape& tape, FirstRoots::Other& found);

    const RootSettings& settings_;
    RootPolish& polish_;
    GradientEvaluator& gradients_;
    std::vector<RoughRoot> rough_;
    std::vector<LineQuery> queries_;
    std::vector<RootList> lists_;
    std::vector<FirstRoots::Other> found_;
};

}  // namespace isoscope
