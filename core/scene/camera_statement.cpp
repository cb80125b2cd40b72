// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/camera_statement.h"

#include <glm/geometric.hpp>

namespace isoscope {

Camera CameraStatement::camera() const {
    Camera camera = start;
    camera.kind = kind;
    camera.location = location.value_or(start.location);
    camera.direction = direction.value_or(start.direction);
    camera.right = right.value_or(start.right);
    camera.up = up.value_or(start.up);
    camera.sky = sky.value_or(start.sky);
    camera.blur = blur.value_or(start.blur);
    camera.lookAt = lookAt.value_or(start.lookAt);
    if (normal) {
        camera.normal = normal;
        camera.normalText = normalText;
    }

    if (kind == CameraKind::spherical && start.kind != kind) camera.angle = 360;
    if (verticalAngle)
        camera.verticalAngle = *verticalAngle;
    else if (angle)
        camera.verticalAngle = *angle / 2;
    if (angle) {
        camera = camera.withAngle(*angle);
    } else if (kind == CameraKind::orthographic && start.kind != CameraKind::orthographic && !right && !up) {
        const double length = glm::length(camera.direction);
        const double factor = length > 0 ? glm::length(camera.lookAt - camera.location) / length : 1;
        camera.right *= factor;
        camera.up *= factor;
    }
    if (lookAt) camera = camera.lookingAt(*lookAt);
    return transform.identity() ? camera : camera.transformed(transform);
}

}  // namespace isoscope
