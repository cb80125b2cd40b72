// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "core/scene/color.h"
#include "core/shapes/shape.h"

namespace isoscope {

/// The rays of a light: to all sides from a point, in a cone, in a cylinder, or parallel everywhere.
enum class LightKind { point, spotlight, cylinder, parallel };

/// The extent of an area light: a grid of `columns` by `rows` lights along two edges, centred at the location
/// of the light source. As POV-Ray's `area_light` and the items that belong to it.
struct LightArea {
    glm::dvec3 edge{0}, otherEdge{0};
    int columns = 1, rows = 1;
    int adaptive = 100;         ///< how fine the first look is; 100: all lights, as without `adaptive`
    bool jitter = false;        ///< the lights of the grid are moved at random
    bool circular = false;      ///< the grid is bent into a disc
    bool orient = false;        ///< the grid faces the point it lights
    bool illumination = false;  ///< surfaces are lit from the whole area, not only its shadows
};

/// A light of the scene, as POV-Ray's light_source.
struct LightSource {
    LightKind kind = LightKind::point;
    glm::dvec3 location{0};
    Color color{1, 1, 1};
    glm::dvec3 pointAt{0, 0, 0};
    double radius = 30;   ///< full light within: half angle of a cone in degrees, radius of a cylinder
    double falloff = 45;  ///< none beyond; as `radius`
    double tightness = 0;
    double fadeDistance = 0;
    double fadePower = 0;
    bool shadowless = false;
    bool mediaAttenuation = false;  ///< fog and media of all space between source and surface dim it
    bool mediaInteraction = true;   ///< media scatter its light
    std::optional<LightArea> area;
    /// Only light that comes through this shape arrives, and only what lies in front of it casts shadows.
    ShapePointer projectedThrough;
    int group = 0;  ///< index into Scene::lightGroups
    int line = 0;   ///< of the statement, for the plan's reasons
};

}  // namespace isoscope
