// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <string>

#include "core/evaluate/tape/tape.h"
#include "core/shapes/rays/ray.h"
#include "core/shapes/rays/ray_bundle.h"
#include "core/shapes/transform.h"

namespace isoscope {

struct SurfaceNormal;

/// POV-Ray's kinds of camera. Perspective and orthographic ones look through a flat picture, the others
/// through a curved one (core/scene/camera_projection.h).
enum class CameraKind {
    perspective,
    orthographic,
    fisheye,
    ultraWideAngle,
    omnimax,
    panoramic,
    spherical,
    uprightCylinder,        ///< `cylinder 1`
    lyingCylinder,          ///< `cylinder 2`
    movingUprightCylinder,  ///< `cylinder 3`: the viewpoint moves along the axis
    movingLyingCylinder,    ///< `cylinder 4`
};

/// Depth of field: rays through one place of the picture start all over a disc, as wide as half of
/// `aperture`, and meet in a plane across the view, as far away as `focalPoint`. As POV-Ray's camera items of
/// these names.
struct FocalBlur {
    double aperture = 0;
    int samples = 0;
    glm::dvec3 focalPoint{0};
    double confidence = 0.9;
    double variance = 1.0 / 128;

    /// Whether there is any.
    bool any() const { return aperture != 0 && samples > 0; }
    bool operator==(const FocalBlur&) const = default;
};

/// POV-Ray's camera: `direction`, `right` and `up` span the picture as the scene leaves them after look_at
/// and angle were applied (CameraStatement knows in which order). The plane of the picture stands one
/// `direction` away from `location`; `right` and `up` are its full width and height. An orthographic camera
/// sends parallel rays along `direction` from the rectangle `right` by `up` around `location`.
struct Camera {
    CameraKind kind = CameraKind::perspective;
    glm::dvec3 location{0};
    glm::dvec3 direction{0, 0, 1};
    glm::dvec3 right{1.33, 0, 0};
    glm::dvec3 up{0, 1, 0};
    glm::dvec3 sky{0, 1, 0};
    glm::dvec3 lookAt{0, 0, 1};
    double angle = 90;           ///< of view, in degrees, of the kinds with a curved picture; else unused
    double verticalAngle = 180;  ///< the same, spherical cameras only
    FocalBlur blur;
    /// Bends the rays, at their places in the picture, as it would bend the normal of a surface; null: none.
    std::shared_ptr<const SurfaceNormal> normal;
    std::shared_ptr<const Tape> normalTape;  ///< made of it by compileMaterials()
    std::string normalText;                  ///< the scene's text of `normal`, for exports

    /// Whether straight lines look straight: the kinds with a flat picture.
    bool flat() const { return kind == CameraKind::perspective || kind == CameraKind::orthographic; }

    /// The ray through (u, v): both run from -0.5 to 0.5, u to the right and v up. Its direction has unit
    /// length; it is zero where the camera is degenerate, and outside of the round picture of a fisheye or
    /// omnimax camera, where nothing is seen.
    Ray ray(double u, double v) const;
    /// Holds the ray through every (u, v) with u and v between these; for a curved picture, any ray.
    RayBundle bundle(double lowU, double highU, double lowV, double highV) const;
    /// The camera turned, by the rules of look_at, so that it looks at `target`: the lengths of `direction`,
    /// `right` and `up` stay, their axes follow `sky`, and a mirrored camera stays mirrored. A target at the
    /// location leaves the camera as it is.
    Camera lookingAt(const glm::dvec3& target) const;
    /// The camera with a horizontal field of view of `degrees` (0 to 180 exclusive, else unchanged).
    /// Perspective: sets the length of `direction`. Orthographic: sets the width and, in proportion, the
    /// height so that they show what a perspective camera would show at the distance of `lookAt`. The other
    /// kinds keep their shape and take any angle above 0.
    Camera withAngle(double degrees) const;
    /// Location and axes carried by `transform`, as transformations inside `camera { }` do.
    Camera transformed(const Transform& transform) const;

    friend bool operator==(const Camera&, const Camera&) = default;
};

}  // namespace isoscope
