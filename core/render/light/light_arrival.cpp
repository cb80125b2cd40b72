// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/light/light_arrival.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "core/render/light/light_aim.h"

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

bool fades(const LightSource& light) { return light.fadePower > 0 && light.fadeDistance != 0; }

double fading(const LightSource& light, double distance) {
    if (!fades(light)) return 1;
    return 2 / (1 + std::pow(distance / light.fadeDistance, light.fadePower));
}

double strengthAt(const LightSource& light, const SurfacePoints& points, std::size_t k) {
    double strength = fading(light, points.distance[k]);
    if (light.kind == LightKind::spotlight) strength *= spotlight(light, -at(points.toLight, k));
    if (light.kind == LightKind::cylinder) strength *= cylinder(light, at(points.point, k));
    // Behind a parallel light that fades by an odd power it is negative, and darkens.
    return std::isfinite(strength) ? strength : 0;
}

}  // namespace

bool spreadsEvenly(const LightSource& light) {
    return !fades(light) && light.kind != LightKind::spotlight && light.kind != LightKind::cylinder;
}

void findArrival(const LightSource& light, SurfacePoints& points) {
    if (light.kind == LightKind::parallel || light.kind == LightKind::cylinder)
        aimAlong(unit(light.location - light.pointAt), light.location, points);
    else
        aimAt(light.location, points);
    if (spreadsEvenly(light)) return;
    for (std::size_t k = 0; k < points.size(); ++k) points.strength[k] = strengthAt(light, points, k);
}

}  // namespace isoscope
