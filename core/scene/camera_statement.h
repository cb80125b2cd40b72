// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "core/scene/camera.h"
#include "core/shapes/transform.h"

namespace isoscope {

/// What a `camera { }` block says, in whatever order it says it. POV-Ray 3.7 gathers all items first (of a
/// repeated one the last counts) and then applies angle, look_at and the transformations, in this order;
/// measured on POV-Ray 3.7.0.10.
struct CameraStatement {
    /// Defaults, or the declared camera that the block starts from.
    Camera start;
    CameraKind kind = CameraKind::perspective;
    std::optional<glm::dvec3> location, direction, right, up, sky, lookAt;
    std::optional<double> angle;
    std::optional<double> verticalAngle;  ///< of spherical cameras; half of `angle` where only that is said
    std::optional<FocalBlur> blur;
    std::shared_ptr<const SurfaceNormal> normal;  ///< null: that of `start`
    std::string normalText;                       ///< as Camera::normalText
    Transform transform;

    /// The camera in force. An orthographic one with neither right, up nor angle shows what the perspective
    /// camera would show at the distance of look_at.
    Camera camera() const;
};

}  // namespace isoscope
