// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "core/render/light/interior_list.h"
#include "core/render/render_plan.h"
#include "core/shapes/rays/ray.h"

namespace isoscope {

/// How a ray came to be: what it sees is added to a sample of the picture with a weight.
struct LightPath {
    glm::dvec3 weight{1};
    std::uint32_t target = 0;  ///< the sample
    std::uint16_t level = 1;   ///< rays from the camera are of level 1
    std::uint16_t steps = 0;   ///< surfaces between the camera and this ray
    bool reflected = false;    ///< a mirror is among them
    bool dispersed = false;    ///< it is of one colour, whose place in the spectrum (spectrum.h) follows
    float spectralPlace = 0;
    InteriorList inside;  ///< where it goes
};

/// A ray that is still to be sent.
struct SecondaryRay {
    Ray ray;  ///< its direction has unit length
    LightPath path;
    StageKind sender = StageKind::directLight;  ///< which stage its cost belongs to
};

}  // namespace isoscope
