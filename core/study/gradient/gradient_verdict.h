// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/study/gradient/gradient_bracket.h"

namespace isoscope {

/// What a max_gradient is worth.
enum class GradientVerdict {
    holes,      ///< somewhere the function is steeper: rays that pass there can lose the surface
    right,      ///< no hole, and at most `wastefulFactor` too high
    wasteful,   ///< no hole, but a smaller one would do and be faster
    unbounded,  ///< no max_gradient is enough everywhere, but the rays of this view met nothing steeper
    unproven,   ///< nothing steeper is known, but it is not excluded either
};

/// Above this many times what would do a max_gradient counts as wasteful.
constexpr double wastefulFactor = 1.25;

/// `alongRays` is the steepest slope that the rays of a picture met, 0 when there is none.
GradientVerdict judgeGradient(double maxGradient, const GradientBracket& bracket, double alongRays);

/// The enumerator's own word, which the reports of the command line print.
std::string_view name(GradientVerdict verdict);

/// The max_gradient to suggest: the smallest round value at or above the proven upper end; infinite where
/// there is no such number.
double suggestedGradient(const GradientBracket& bracket);

}  // namespace isoscope
