// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/fog_depth.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/numeric/noise.h"

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

/// spec/noise.md, section 7.
double turbulence(const Fog& fog, glm::dvec3 place, int generator) {
    const auto part = [&](const glm::dvec3& p) {
        const double value = noise(generator, p.x, p.y, p.z);
        return generator > 1 ? 2 * value - 0.5 : value;
    };
    double sum = part(place);
    if (generator > 1) sum = std::clamp(sum, 0.0, 1.0);
    const double omega = static_cast<float>(fog.omega), lambda = static_cast<float>(fog.lambda);
    double weight = 1;
    for (int octave = 2; octave <= fog.octaves; ++octave) {
        weight *= omega;
        place *= lambda;
        sum += weight * part(place);
    }
    return sum;
}

}  // namespace

double fogDepth(const Fog& fog, const Ray& ray, double distance, int noiseGenerator) {
    const double way = std::min(distance, farthest);
    double depth = way / fog.distance;
    if (fog.ground) {
        const double size = glm::length(fog.up);
        const glm::dvec3 up = size > 0 ? fog.up / size : glm::dvec3(0, 1, 0);
        const double from = glm::dot(up, ray.origin) - fog.offset;
        depth *= meanDensity(from, from + way * glm::dot(up, ray.direction), fog.altitude);
    }
    if (fog.turbulence != glm::dvec3(0)) {
        const glm::dvec3 place = fog.turbulence * (ray.origin + 0.5 * way * ray.direction);
        const double thinner = std::min(1.0, fog.turbulenceDepth * turbulence(fog, place, noiseGenerator));
        depth *= 1 - thinner * std::exp(-way / fog.distance);
    }
    return std::isnan(depth) ? 0 : depth;
}

double leftByFog(const Fog& fog, const Ray& ray, double distance, int noiseGenerator) {
    return std::max(std::exp(-fogDepth(fog, ray, distance, noiseGenerator)), fog.color.transmit);
}

glm::dvec3 filteredByFog(const Fog& fog, double left) {
    const glm::dvec3 color(fog.color.red, fog.color.green, fog.color.blue);
    return left * ((1 - fog.color.filter) * glm::dvec3(1) + fog.color.filter * color);
}

}  // namespace isoscope
