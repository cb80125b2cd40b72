// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/function/graph_builder.h"
#include "core/scene/pigment.h"

namespace isoscope {

/// Red, green, blue, filter, transmit.
using ColorExpression = std::array<Expression, 5>;

/// What patterns take from the scene.
struct PatternSettings {
    int noiseGenerator = 2;
    /// `number_of_waves`; POV-Ray counts it for pictures only, functions always have 10.
    int numberOfWaves = 10;
};

/// The colour of a pigment at a point, with all its maps, as POV-Ray 3.7 has it (golden/patterns.csv).
ColorExpression pigmentColor(const Pigment& pigment, const PatternPoint& point,
                             const PatternSettings& settings);

/// Its brightness().
Expression grayOf(const ColorExpression& color);

/// The point <u, v, 0> of the surface that a texture of this graph is on.
PatternPoint surfacePoint(FunctionGraph& graph);

/// The same as a function of x, y and z with five results; of all arguments of surface_variables.h where the
/// pigment asks for them. Not valid when the pigment is too large for a graph. For an image it gives the
/// place in the image, in three results.
Function pigmentFunction(const Pigment& pigment, const PatternSettings& settings);

/// The value of a pattern in the same way, with one result.
Function patternFunction(const Pattern& pattern, const PatternSettings& settings, bool onSurface = false);

}  // namespace isoscope
