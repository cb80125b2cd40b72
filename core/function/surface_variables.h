// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/function/graph_builder.h"

namespace isoscope {

/// Arguments that functions of textures may have beyond the point (0 to 2) and, of normals, the normal that
/// is bent (3 to 5): what the place on the surface knows besides. All in coordinates of the world.
namespace surface_variable {
constexpr int normal = 6;  ///< and the next two: unit length, to the side that is looked at
constexpr int view = 9;    ///< and the next two: where the ray goes, unit length
constexpr int place = 12;  ///< and the next one: u and v of `uv_mapping`
constexpr int count = 14;
}  // namespace surface_variable

/// Component `axis` of the vector that begins with argument `first`.
inline Expression surfaceVariable(FunctionGraph& graph, int first, int axis) {
    return {graph, graph.variable(first + axis)};
}

}  // namespace isoscope
