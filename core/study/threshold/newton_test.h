// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "core/evaluate/interval_gradient_evaluator.h"
#include "core/study/gradient/gradient_domain.h"
#include "core/study/threshold/critical_point.h"

namespace isoscope {

/// What Krawczyk's operator says of zeros of the gradient in a box (R. Krawczyk, Computing 4, 1969; "Newton
/// Algorithms for Evaluation of Roots with Error Bounds").
struct NewtonVerdict {
    /// How many zeros there are.
    enum class Kind {
        none,  ///< there is no zero in the box
        one,   ///< there is exactly one
        atMostOne,
        open,  ///< nothing is known
    };
    Kind kind = Kind::open;
    GradientBox
        rest;  ///< the part of the box that holds all its zeros; the box itself where nothing is known
};

/// Looks for zeros of a gradient by interval Newton steps. All that it says is proven, in real arithmetic,
/// for the function as IntervalGradientEvaluator understands it. Not for several threads at once.
class NewtonTest {
  public:
    /// The evaluator must outlive it.
    explicit NewtonTest(IntervalGradientEvaluator& intervals) : intervals_(intervals) {}

    /// Whether second derivatives are known in the whole box, which the other functions need.
    static bool covers(const IntervalGradient& whole);

    /// `whole`: the evaluation of the box.
    NewtonVerdict test(const GradientBox& box, const IntervalGradient& whole);
    /// A single zero.
    struct Found {
        GradientBox alone;  ///< there is no other one in it
        GradientBox rest;   ///< small
    };
    /// The zero that plain Newton steps from the centre of a box lead to, with the largest box around it
    /// alone that a few tries find; nothing where they fail.
    std::optional<Found> lookAround(const GradientBox& box, const IntervalGradient& whole);
    /// The smallest box around the only zero of a box that further steps reach.
    GradientBox narrow(GradientBox box);
    /// The signs of the second derivatives over a box; `unknown` where one is not certain.
    CriticalKind kindIn(const GradientBox& box);

  private:
    std::optional<glm::dvec3> stepsFrom(glm::dvec3 point, double reach);

    IntervalGradientEvaluator& intervals_;
};

}  // namespace isoscope
