// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/study/accuracy/setting_effects.h"
#include "core/study/gradient/gradient_bracket.h"
#include "core/study/gradient/gradient_verdict.h"

namespace isoscope {

/// All that is known of what one isosurface's max_gradient is worth.
struct SurfaceVerdict {
    std::size_t isosurface = 0;
    double setting = 0;  ///< max_gradient in force
    GradientBracket bracket;
    /// In the view at hand; nothing while they are not counted.
    std::optional<SurfaceEffects> effects;
    std::uint64_t pixels = 0;  ///< of that view
    /// How many times as long as with suggestedGradient() POV-Ray takes for the view, by its evaluations.
    std::optional<double> waste;

    /// Nothing while more has to be proven to say.
    std::optional<GradientVerdict> verdict() const;
    /// What "Use" writes: suggestedGradient(), once a tighter bracket would not change it; nothing where
    /// there is no such number.
    std::optional<double> suggested() const;
    /// Whether mistakes are possible, so that they are worth counting.
    bool mayLose() const;
};

/// From good to bad, for choosing the worst of many; nothing (being proven) lies between right and the rest.
int badness(std::optional<GradientVerdict> verdict);

}  // namespace isoscope
