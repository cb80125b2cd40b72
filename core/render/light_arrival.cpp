// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/light_arrival.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace isoscope {

namespace {

/// 1 from `high` on, 0 below `low`, a smooth cubic in between. `low` above `high` (falloff within radius)
/// leaves a sharp step.
double smoothStep(double low, double high, double value) {
    if (value >= high) return 1;
    if (value <= low) return 0;
    const double x = (value - low) / (high - low);
    return x * x * (3 - 2 * x);
}

glm::dvec3 unit(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec3(0);
}

double spotlight(const LightSource& light, const glm::dvec3& fromLight) {
    const double cosine = glm::dot(fromLight, unit(light.pointAt - light.location));
    if (!(cosine > 0)) return 0;
    const double tight = std::pow(cosine, light.tightness);
    return tight *
           smoothStep(std::cos(glm::radians(light.falloff)), std::cos(glm::radians(light.radius)), cosine);
}

double cylinder(const LightSource& light, const glm::dvec3& point) {
    const glm::dvec3 axis = unit(light.pointAt - light.location);
    const glm::dvec3 arm = point - light.location;
    const double along = glm::dot(arm, axis);
    if (!(along > 0)) return 0;
    const double across = glm::length(arm - along * axis);
    if (across >= light.falloff) return 0;
    const double tight = std::pow(1 - across / light.falloff, light.tightness);
    return tight * smoothStep(-light.falloff, -light.radius, -across);
}

double fading(const LightSource& light, double distance) {
    if (!(light.fadePower > 0)) return 1;
    if (!(light.fadeDistance > 0)) return 1;
    return 2 / (1 + std::pow(distance / light.fadeDistance, light.fadePower));
}

}  // namespace

LightArrival lightArrival(const LightSource& light, const glm::dvec3& point) {
    LightArrival arrival;
    arrival.highlights = !light.shadowless;
    const glm::dvec3 arm = light.location - point;
    if (light.kind == LightKind::parallel || light.kind == LightKind::cylinder) {
        arrival.direction = unit(light.location - light.pointAt);
        arrival.distance = glm::dot(arm, arrival.direction);
    } else {
        arrival.distance = glm::length(arm);
        arrival.direction = unit(arm);
    }
    double strength = fading(light, arrival.distance);
    if (light.kind == LightKind::spotlight) strength *= spotlight(light, -arrival.direction);
    if (light.kind == LightKind::cylinder) strength *= cylinder(light, point);
    if (strength > 0 && std::isfinite(strength)) arrival.color = rgb(light.color) * strength;
    return arrival;
}

}  // namespace isoscope
