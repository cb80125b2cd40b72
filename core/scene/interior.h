// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/scene/color.h"

namespace isoscope {

/// Index into Scene::interiors.
using InteriorId = std::int32_t;
constexpr InteriorId noInterior = -1;

struct Medium;

/// What is inside of an object, for the light that goes through it: POV-Ray's `interior`.
struct Interior {
    double ior = 1;
    double caustics = 0;
    double dispersion = 1;
    int dispersionSamples = 7;
    double fadeDistance = 0;
    double fadePower = 0;
    Color fadeColor{};
    /// Fog and media reach into the object.
    bool hollow = false;
    /// What fills it, where it is hollow; none is null.
    std::vector<std::shared_ptr<const Medium>> media;
    int lightGroup = 0;  ///< whose lights they scatter: index into Scene::lightGroups, as of its object

    /// Whether light is dimmed in passing through (POV-Ray's fade_distance and fade_power).
    bool fades() const { return fadeDistance > 0; }
};

}  // namespace isoscope
