// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/animation/camera_pose.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace isoscope {

namespace {

/// Angles of view that agree to this are the same: the camera keeps its axes to the last bit.
constexpr double angleTolerance = 1e-9;
constexpr double fullTurn = 360;

double angleOf(const Camera& camera, double distance) {
    if (!camera.flat()) return camera.angle;
    const double length = camera.kind == CameraKind::orthographic ? distance : glm::length(camera.direction);
    return 2 * glm::degrees(std::atan2(glm::length(camera.right) / 2, length));
}

}  // namespace

const std::array<std::string_view, cameraTrackCount>& cameraTrackNames() {
    static constexpr std::array<std::string_view, cameraTrackCount> names{
        "camera azimuth",   "camera elevation", "camera distance", "camera look_at x",
        "camera look_at y", "camera look_at z", "camera angle"};
    return names;
}

bool isCameraTrack(std::string_view name) {
    const auto& names = cameraTrackNames();
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::array<double, cameraTrackCount> poseNumbers(const CameraPose& pose) {
    return {pose.azimuth,  pose.elevation, pose.distance, pose.lookAt.x,
            pose.lookAt.y, pose.lookAt.z,  pose.angle};
}

CameraPose poseOfNumbers(const std::array<double, cameraTrackCount>& numbers) {
    return {numbers[0], numbers[1], numbers[2], {numbers[3], numbers[4], numbers[5]}, numbers[6]};
}

PoseAxes poseAxes(const Camera& camera) {
    const double length = glm::length(camera.sky);
    const glm::dvec3 sky = length > 0 ? camera.sky / length : glm::dvec3(0, 1, 0);
    constexpr double nearlyAlong = 0.9;
    const glm::dvec3 start = std::abs(sky.z) < nearlyAlong ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
    const glm::dvec3 front = glm::normalize(start - glm::dot(start, sky) * sky);
    return {front, glm::cross(front, sky), sky};
}

CameraPose poseOf(const Camera& camera, const glm::dvec3& lookAt, double near) {
    const PoseAxes axes = poseAxes(camera);
    const glm::dvec3 way = camera.location - lookAt;
    CameraPose pose;
    pose.lookAt = lookAt;
    pose.distance = glm::length(way);
    const double along = glm::dot(way, axes.front), across = glm::dot(way, axes.side);
    pose.elevation = glm::degrees(std::atan2(glm::dot(way, axes.sky), std::hypot(along, across)));
    const double azimuth = glm::degrees(std::atan2(across, along));
    pose.azimuth = azimuth + fullTurn * std::round((near - azimuth) / fullTurn);
    pose.angle = angleOf(camera, pose.distance);
    return pose;
}

Camera posedCamera(const Camera& camera, const CameraPose& pose) {
    for (const double number : poseNumbers(pose))
        if (!std::isfinite(number)) return camera;
    if (!(pose.distance > 0)) return camera;
    const PoseAxes axes = poseAxes(camera);
    const double azimuth = glm::radians(pose.azimuth), elevation = glm::radians(pose.elevation);
    Camera posed = camera;
    posed.location = pose.lookAt + pose.distance * (std::cos(elevation) * (std::cos(azimuth) * axes.front +
                                                                           std::sin(azimuth) * axes.side) +
                                                    std::sin(elevation) * axes.sky);
    posed.lookAt = pose.lookAt;
    posed = posed.lookingAt(pose.lookAt);
    return std::abs(angleOf(posed, pose.distance) - pose.angle) > angleTolerance ? posed.withAngle(pose.angle)
                                                                                 : posed;
}

}  // namespace isoscope
