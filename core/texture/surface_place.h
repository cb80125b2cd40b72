// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/geometric.hpp>

#include "core/function/surface_variables.h"
#include "core/scene/material.h"

namespace isoscope {

/// What a place on a surface knows besides its point: the further arguments of tapes of textures
/// (surface_variables.h).
struct SurfacePlace {
    glm::dvec3 normal{0};
    glm::dvec3 view{0};
    glm::dvec2 place{0};
};

using SurfaceArguments = std::array<double, surface_variable::count>;

/// Whether a tape asks for more than a point and a normal.
inline bool needsSurface(const Tape& tape) { return tape.argumentCount() == surface_variable::count; }

/// All arguments, for a point and a normal in the coordinates of the texture.
inline SurfaceArguments surfaceArguments(const glm::dvec3& point, const glm::dvec3& normal,
                                         const SurfacePlace& surface) {
    return {point.x,        point.y,          point.z,          normal.x,         normal.y,
            normal.z,       surface.normal.x, surface.normal.y, surface.normal.z, surface.view.x,
            surface.view.y, surface.view.z,   surface.place.x,  surface.place.y};
}

/// u and v of the point: those of the material's shape, or x and y.
inline glm::dvec2 surfaceCoordinates(const Material& material, const glm::dvec3& point) {
    const glm::dvec2 plain(point.x, point.y);
    if (!material.surface) return plain;
    const TexturedShape& on = *material.surface;
    return on.shape->surfacePlace(on.transform.inversePoint(point)).value_or(plain);
}

}  // namespace isoscope
