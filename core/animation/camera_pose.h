// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <string_view>

#include "core/scene/camera.h"

namespace isoscope {

/// Where a camera stands, as keys move it: around the point that it looks at, upright by its `sky`.
struct CameraPose {
    double azimuth = 0;    ///< degrees about the sky, any number of turns; 0: the camera looks along +z,
                           ///< 90: along -x (of a sky along y)
    double elevation = 0;  ///< degrees above that point, -90 to 90
    double distance = 1;   ///< > 0
    glm::dvec3 lookAt{0};  ///< the point
    double angle = 90;     ///< of view across, in degrees
};

constexpr std::size_t cameraTrackCount = 7;

/// The tracks that move the camera: "camera azimuth" and so on, in the order of poseNumbers().
const std::array<std::string_view, cameraTrackCount>& cameraTrackNames();
/// Whether it is the name of one of them.
bool isCameraTrack(std::string_view name);

/// The pose as numbers, and back.
std::array<double, cameraTrackCount> poseNumbers(const CameraPose& pose);
CameraPose poseOfNumbers(const std::array<double, cameraTrackCount>& numbers);

/// The axes that azimuth and elevation are counted by, each of unit length.
struct PoseAxes {
    glm::dvec3 front;  ///< from the point to a camera with azimuth and elevation 0
    glm::dvec3 side;   ///< azimuth 90
    glm::dvec3 sky;    ///< elevation 90
};
/// Those of a camera's sky; of y where it has none.
PoseAxes poseAxes(const Camera& camera);

/// How the camera stands around `lookAt`; its azimuth is the one nearest to `near`, so that keys do not turn
/// the long way round.
CameraPose poseOf(const Camera& camera, const glm::dvec3& lookAt, double near = 0);

/// The camera in that pose; kind, proportions, blur and all the rest are those of `camera`. A pose with
/// numbers that no camera can have gives `camera` as it is.
Camera posedCamera(const Camera& camera, const CameraPose& pose);

}  // namespace isoscope
