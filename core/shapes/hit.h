// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace isoscope {

/// Index into Scene::materials; noMaterial takes the enclosing object's.
using MaterialId = std::int32_t;
constexpr MaterialId noMaterial = -1;

/// What kind of place a ray has met.
enum class HitKind : std::uint8_t {
    crossing,   ///< the level set itself (or the surface of any other shape)
    container,  ///< the wall of an isosurface's container
    jump,       ///< a sign change across a discontinuity
    pole,       ///< a sign change through infinity
};

/// The word for a kind in the output of `trace`, e.g. "crossing": static text.
const char* name(HitKind kind);

/// A place where a ray meets a shape.
struct Hit {
    double t = 0;          ///< in units of the ray's direction
    glm::dvec3 point{0};   ///< world coordinates
    glm::dvec3 normal{0};  ///< unit length, out of the solid, never turned towards the ray; never NaN
    MaterialId material = noMaterial;
    HitKind kind = HitKind::crossing;
};

/// Hits in order of t.
using HitList = std::vector<Hit>;

}  // namespace isoscope
