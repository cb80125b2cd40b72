// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>
#include <string>

#include "core/shapes/shape.h"
#include "core/virtualight/document.h"

namespace isoscope::virtualight {

/// A primitive as a shape, with the transform that puts it into its place.
struct DrawnPrimitive {
    ShapePointer shape;
    Transform place;
    std::string problem;  ///< why there is no shape, a sentence
    std::string hint;
};

/// `parameterTable` holds the values of sliders that implicit surfaces read. The Bound of the modifiers cuts
/// the shape off, in its own coordinates, and leaves it open. There is no shape, and no problem, when `stop`
/// is requested meanwhile.
DrawnPrimitive drawPrimitive(const Primitive& primitive, const ShapeModifiers& modifiers,
                             std::span<const double> parameterTable, const std::stop_token& stop = {});

/// Points that estimatedGradient() looks at.
constexpr std::size_t gradientPoints = 25 * 25 * 25;

/// A max_gradient for POV-Ray's root finder: the steepest slope between points of a net over the box, and
/// half as much again. Our own pictures do not depend on it.
double estimatedGradient(const Function& function, const std::array<glm::dvec3, 2>& box,
                         std::span<const double> parameterTable);

/// The pieces of an extruded profile in the coordinates of a prism, and the transform from there: its x and z
/// are the profile's x and y, its height the way along the direction.
Transform extrusionPlace(const glm::dvec3& direction);

}  // namespace isoscope::virtualight
