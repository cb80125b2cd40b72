// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/light/light_arrival.h"

#include <algorithm>
#include <array>
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

/// The shape of a light's beam.
struct Beam {
    explicit Beam(const LightSource& light)
        : axis(unit(light.pointAt - light.location)),
          innermost(std::cos(glm::radians(light.radius))),
          outermost(std::cos(glm::radians(light.falloff))) {}

    glm::dvec3 axis;
    double innermost, outermost;  ///< cosines of half angles
};

double spotlight(const LightSource& light, const Beam& beam, const glm::dvec3& fromLight) {
    const double cosine = glm::dot(fromLight, beam.axis);
    if (!(cosine > 0)) return 0;
    const double part = smoothStep(beam.outermost, beam.innermost, cosine);
    return part == 0 ? 0 : std::pow(cosine, light.tightness) * part;
}

double cylinder(const LightSource& light, const Beam& beam, const glm::dvec3& point) {
    const glm::dvec3& axis = beam.axis;
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

double strengthAt(const LightSource& light, const Beam& beam, const SurfacePoints& points, std::size_t k) {
    double strength = fading(light, points.distance[k]);
    if (light.kind == LightKind::spotlight) strength *= spotlight(light, beam, -at(points.toLight, k));
    if (light.kind == LightKind::cylinder) strength *= cylinder(light, beam, at(points.point, k));
    // Behind a parallel light that fades by an odd power it is negative, and darkens.
    return std::isfinite(strength) ? strength : 0;
}

}  // namespace

bool spreadsEvenly(const LightSource& light) {
    return !fades(light) && light.kind != LightKind::spotlight && light.kind != LightKind::cylinder;
}

void addBeamStretches(const LightSource& light, const Ray& ray, double distance,
                      std::vector<BeamStretch>& stretches) {
    if (light.kind != LightKind::spotlight && light.kind != LightKind::cylinder) return;
    const Beam beam(light);
    const bool cone = light.kind == LightKind::spotlight;
    const glm::dvec3 arm = ray.origin - light.location;
    // On the border the square of the arm is `steep` times that of its part along the axis, and `rest` more.
    const double steep = cone ? 1 / (beam.outermost * beam.outermost) : 1;
    const double rest = cone ? 0 : light.falloff * light.falloff;
    const double along = glm::dot(ray.direction, beam.axis), height = glm::dot(arm, beam.axis);
    const double a = glm::dot(ray.direction, ray.direction) - steep * along * along;
    const double b = glm::dot(ray.direction, arm) - steep * along * height;
    const double c = glm::dot(arm, arm) - steep * height * height - rest;
    const double root = std::sqrt(std::max(b * b - a * c, 0.0));
    std::array<double, 6> borders{0, distance};
    std::size_t count = 2;
    // Where the beam begins, and its sides.
    for (const double t : {-height / along, (-b - root) / a, (-b + root) / a, -c / (2 * b)})
        if (t > 0 && t < distance) borders[count++] = t;
    std::sort(borders.begin(), borders.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t k = 0; k + 1 < count; ++k) {
        const double middle = (borders[k] + borders[k + 1]) / 2;
        const glm::dvec3 place = arm + middle * ray.direction;
        const double far = glm::dot(place, beam.axis);
        if (far > 0 && glm::dot(place, place) < steep * far * far + rest)
            stretches.push_back({borders[k], borders[k + 1]});
    }
}

void findArrival(const LightSource& light, SurfacePoints& points) {
    if (light.kind == LightKind::parallel || light.kind == LightKind::cylinder)
        aimAlong(unit(light.location - light.pointAt), light.location, points);
    else
        aimAt(light.location, points);
    if (spreadsEvenly(light)) return;
    const Beam beam(light);
    for (std::size_t k = 0; k < points.size(); ++k) points.strength[k] = strengthAt(light, beam, points, k);
}

}  // namespace isoscope
