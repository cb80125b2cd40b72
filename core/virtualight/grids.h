// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <stop_token>

#include "core/shapes/patches/height_field.h"
#include "core/shapes/patches/surface_grid.h"
#include "core/virtualight/document.h"

namespace isoscope::virtualight {

/// The pixels of a planar field, over the largest value that they can have. The last row of the image lies at
/// z = 0, as in POV-Ray.
HeightGrid heightsOf(const ImageField& field);

/// The net of triangles that a patch, a NURBS or parametric surface, or a height field is drawn as; nothing
/// for other primitives. Steps and domain come from the modifiers, or are `defaultSteps` and 0 to 1.
/// Without a point when `stop` is requested meanwhile.
std::optional<SurfaceGrid> gridOf(const Primitive& primitive, const ShapeModifiers& modifiers,
                                  const std::stop_token& stop = {});

constexpr int defaultSteps = 32;

/// The points of a bicubic patch in any basis as control points of the Bezier basis.
std::array<glm::dvec3, 16> bezierPoints(const BicubicShape& patch);

/// The rotation that takes direction `from` to direction `to` the shortest way; both have a length.
Transform turning(const glm::dvec3& from, const glm::dvec3& to);

}  // namespace isoscope::virtualight
