// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/solids/superellipsoid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "core/roots/polynomial/bracketed_root.h"
#include "core/roots/polynomial/real_roots.h"
#include "core/shapes/rays/hit_list.h"

namespace isoscope {

namespace {

struct Range {
    double low, high;
};

/// x^exponent for x in [low, high], 0 <= low; infinite at 0 when the exponent is negative.
Range powerRange(double low, double high, double exponent) {
    const double a = std::pow(low, exponent), b = std::pow(high, exponent);
    return {std::min(a, b), std::max(a, b)};
}

/// Neither has a sign.
Range product(const Range& a, const Range& b) {
    const double low = a.low * b.low, high = a.high * b.high;
    return {std::isnan(low) ? 0 : low, std::isnan(high) ? INFINITY : high};
}

constexpr double slack = 1e-13;
/// How far outside points still count as inside, in POV-Ray's measure of distance: (value + 1)^(n/2) - 1.
constexpr double skin = 1e-10;
constexpr int depthLimit = 60;
/// Below it the powers of x and y are too small for doubles; they are taken in units of the greater one.
constexpr double smallExponent = 0.05;
/// Of the intervals of one ray: rays need some tens, grazing ones hundreds.
constexpr int halvingLimit = 10'000;

}  // namespace

/// What one ray is searched with.
struct Superellipsoid::Search {
    glm::dvec3 origin, direction;
    double narrowest;  ///< intervals are not halved further
    int halvings = 0;
    RootSequence roots;

    glm::dvec3 sizeAt(double s) const { return glm::abs(origin + s * direction); }
};

double Superellipsoid::section(double x, double y) const {
    if (e_ >= smallExponent) return std::pow(std::pow(x, 2 / e_) + std::pow(y, 2 / e_), e_ / n_);
    const double wide = std::max(x, y), ratio = wide > 0 ? std::min(x, y) / wide : 0;
    return std::pow(wide * std::pow(1 + std::pow(ratio, 2 / e_), e_ / 2), 2 / n_);
}

double Superellipsoid::unitOf(const glm::dvec3& p) const {
    const double wide = std::max(p.x, p.y);
    return e_ < smallExponent && wide > 0 ? wide : 1;
}

double Superellipsoid::value(const glm::dvec3& p) const {
    return section(p.x, p.y) + std::pow(p.z, 2 / n_) - 1;
}

void Superellipsoid::intersect(const Ray& ray, RayInterval interval, TraceContext& context,
                               HitList& hits) const {
    ++context.rays;
    constexpr double room = 1e-9;
    const RayInterval inside = Bounds{glm::dvec3(-1 - room), glm::dvec3(1 + room)}.clip(ray);
    if (inside.empty() || !std::isfinite(inside.far)) return;
    // Measured from where the ray enters the box, which keeps all numbers small.
    Search search{ray.at(inside.near), ray.direction, 1e-15 * (inside.far - inside.near), 0, {}};
    const double length = inside.far - inside.near;
    std::array<double, 5> ends{0, length, length, length, length};
    std::size_t count = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double s = -search.origin[axis] / search.direction[axis];
        if (s > 0 && s < length) ends[count++] = s;
    }
    std::sort(ends.begin(), ends.begin() + static_cast<std::ptrdiff_t>(count));
    ends[count] = length;
    for (std::size_t k = 0; k < count; ++k) {
        if (!(ends[k] < ends[k + 1])) continue;
        const double from = value(search.sizeAt(ends[k])), to = value(search.sizeAt(ends[k + 1]));
        this->search(search, ends[k], ends[k + 1], from, to, 0);
    }
    search.roots.sort();
    for (const double s : search.roots) {
        const double t = inside.near + s;
        if (!(interval.near <= t && t <= interval.far)) continue;
        const glm::dvec3 at = search.origin + s * search.direction;
        hits.push_back({t, ray.at(t), normalAt(at)});
    }
}

void Superellipsoid::search(Search& search, double from, double to, double valueFrom, double valueTo,
                            int depth) const {
    const glm::dvec3 a = search.sizeAt(from), b = search.sizeAt(to);
    const glm::dvec3 low = glm::min(a, b), high = glm::max(a, b);
    if (value(low) > slack || value(high) < -slack) return;
    const bool changes = (valueFrom > 0) != (valueTo > 0);
    if (monotone(low, high, b - a) || depth == depthLimit || to - from <= search.narrowest ||
        ++search.halvings > halvingLimit) {
        if (!changes) return;
        const auto along = [&](double s) { return value(search.sizeAt(s)); };
        search.roots.add(bracketedRoot(along, from, to, valueFrom, valueTo));
        return;
    }
    const double middle = from + (to - from) / 2, valueMiddle = value(search.sizeAt(middle));
    this->search(search, from, middle, valueFrom, valueMiddle, depth + 1);
    this->search(search, middle, to, valueMiddle, valueTo, depth + 1);
}

bool Superellipsoid::monotone(const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& speed) const {
    const double unit = unitOf(high);
    const glm::dvec3 from = low / unit, to = high / unit;
    const double power = 2 / e_, scale = unit == 1 ? 1 : std::pow(unit, 2 / n_ - 1);
    const double sectionLow = std::pow(from.x, power) + std::pow(from.y, power);
    const double sectionHigh = std::pow(to.x, power) + std::pow(to.y, power);
    const Range outer = product({scale, scale}, powerRange(sectionLow, sectionHigh, e_ / n_ - 1));
    const std::array<Range, 3> slopes{product(outer, powerRange(from.x, to.x, power - 1)),
                                      product(outer, powerRange(from.y, to.y, power - 1)),
                                      powerRange(low.z, high.z, 2 / n_ - 1)};
    double least = 0, most = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const Range& slope = slopes[static_cast<std::size_t>(axis)];
        if (speed[axis] == 0) continue;
        const double one = slope.low * speed[axis], other = slope.high * speed[axis];
        least += std::min(one, other);
        most += std::max(one, other);
    }
    return least > 0 || most < 0;
}

glm::dvec3 Superellipsoid::normalAt(const glm::dvec3& point) const {
    const glm::dvec3 p = glm::abs(point);
    const double unit = unitOf(p), x = p.x / unit, y = p.y / unit;
    const auto slope = [](double a, double exponent) { return a > 0 ? std::pow(a, exponent) : 0; };
    const double sum = std::pow(x, 2 / e_) + std::pow(y, 2 / e_);
    const double outer = sum > 0 ? section(p.x, p.y) / (unit * sum) : 0;
    const glm::dvec3 size(outer * slope(x, 2 / e_ - 1), outer * slope(y, 2 / e_ - 1), slope(p.z, 2 / n_ - 1));
    return unitNormal(
        {std::copysign(size.x, point.x), std::copysign(size.y, point.y), std::copysign(size.z, point.z)});
}

bool Superellipsoid::contains(const glm::dvec3& point, TraceContext&) const {
    return std::pow(value(glm::abs(point)) + 1, n_ / 2) <= 1 + skin;
}

}  // namespace isoscope
