// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/light/fog_depth.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace isoscope {

namespace {

/// Beyond, everything is as far away; POV-Ray has a limit, too.
constexpr double farthest = 1e10;

/// Integral of the density from 0 to a height above the offset.
double densityUpTo(double height, double altitude) {
    if (height <= 0) return height;
    return altitude > 0 ? altitude * std::atan(height / altitude) : 0;
}

double densityAt(double height, double altitude) {
    if (height <= 0) return 1;
    const double ratio = height / altitude;
    return altitude > 0 ? 1 / (1 + ratio * ratio) : 0;
}

/// Mean density between two heights.
double meanDensity(double from, double to, double altitude) {
    const double rise = to - from;
    // Where the heights are close the difference of two integrals has no digits left.
    if (std::abs(rise) < 1e-6 * (1 + std::abs(from))) return densityAt(0.5 * (from + to), altitude);
    return (densityUpTo(to, altitude) - densityUpTo(from, altitude)) / rise;
}

}  // namespace

double fogDepth(const Fog& fog, const Ray& ray, double distance, double turbulence) {
    const double way = std::min(distance, farthest);
    double depth = way / fog.distance;
    if (fog.ground) {
        const double size = glm::length(fog.up);
        const glm::dvec3 up = size > 0 ? fog.up / size : glm::dvec3(0, 1, 0);
        const double from = glm::dot(up, ray.origin) - fog.offset;
        depth *= meanDensity(from, from + way * glm::dot(up, ray.direction), fog.altitude);
    }
    if (fog.turbulence != glm::dvec3(0)) {
        const double thinner = std::min(1.0, fog.turbulenceDepth * turbulence);
        depth *= 1 - thinner * std::exp(-way / fog.distance);
    }
    return std::isnan(depth) ? 0 : depth;
}

glm::dvec3 turbulencePlace(const Fog& fog, const Ray& ray, double distance) {
    return fog.turbulence * (ray.origin + 0.5 * std::min(distance, farthest) * ray.direction);
}

double leftByFog(const Fog& fog, const Ray& ray, double distance, double turbulence) {
    return std::max(std::exp(-fogDepth(fog, ray, distance, turbulence)), fog.color.transmit);
}

glm::dvec3 filteredByFog(const Fog& fog, double left) {
    const glm::dvec3 color(fog.color.red, fog.color.green, fog.color.blue);
    return left * ((1 - fog.color.filter) * glm::dvec3(1) + fog.color.filter * color);
}

}  // namespace isoscope
