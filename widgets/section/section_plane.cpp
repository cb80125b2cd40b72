// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/section/section_plane.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace isoscope {

namespace {

/// The part of a convex polygon where coordinate `k` of the points of the plane is at most `most`, or with
/// `sign` -1 at least -`most`.
std::vector<glm::dvec2> clipped(const std::vector<glm::dvec2>& polygon, const SectionPlane& plane, int k,
                                double sign, double most) {
    std::vector<glm::dvec2> kept;
    const auto excess = [&](const glm::dvec2& p) { return sign * plane.at(p.x, p.y)[k] - most; };
    // A wall of the container counts as inside it, rounding or not.
    const double slack = 1e-12 * (1 + std::abs(most));
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double ea = excess(a), eb = excess(b);
        if (ea <= slack) kept.push_back(a);
        if ((ea <= slack) != (eb <= slack)) kept.push_back(a + ea / (ea - eb) * (b - a));
    }
    return kept;
}

glm::dvec3 centerOf(const Container& container) {
    const Bounds bounds = containerBounds(container);
    return 0.5 * bounds.low + 0.5 * bounds.high;
}

}  // namespace

Bounds containerBounds(const Container& container) {
    if (const auto* sphere = std::get_if<ContainerSphere>(&container))
        return {sphere->center - sphere->radius, sphere->center + sphere->radius};
    const auto& box = std::get<ContainerBox>(container);
    return {box.low, box.high};
}

SectionPlane SectionPlane::across(int axis, double position) {
    // What is drawn to the right and upwards: y up where it can be.
    constexpr int horizontal[] = {2, 0, 0}, vertical[] = {1, 2, 1};
    SectionPlane plane{Unset{}};
    plane.axis_ = std::clamp(axis, 0, 2);
    plane.position_ = position;
    plane.origin_ = plane.right_ = plane.up_ = plane.normal_ = glm::dvec3(0);
    plane.origin_[plane.axis_] = position;
    plane.right_[horizontal[plane.axis_]] = 1;
    plane.up_[vertical[plane.axis_]] = 1;
    plane.normal_[plane.axis_] = 1;
    return plane;
}

SectionPlane SectionPlane::turned(const glm::dvec3& center, double heading, double tilt, double distance) {
    const double a = glm::radians(heading), e = glm::radians(tilt);
    SectionPlane plane{Unset{}};
    plane.axis_ = -1;
    plane.position_ = distance;
    plane.heading_ = heading;
    plane.tilt_ = tilt;
    plane.normal_ = {std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)};
    plane.right_ = {std::cos(a), 0, -std::sin(a)};
    plane.up_ = {-std::sin(e) * std::sin(a), std::cos(e), -std::sin(e) * std::cos(a)};
    plane.origin_ = center + distance * plane.normal_;
    return plane;
}

glm::dvec2 SectionPlane::footOf(const glm::dvec3& point) const {
    const glm::dvec3 d = point - origin_;
    return {glm::dot(d, right_), glm::dot(d, up_)};
}

glm::dvec3 SectionPlane::middle(const Container& container) const {
    const glm::dvec2 foot = footOf(centerOf(container));
    return at(foot.x, foot.y);
}

PlaneAngles anglesOf(const glm::dvec3& normal, double heading) {
    const double length = glm::length(normal);
    if (!(length > 0) || !std::isfinite(length)) return {heading, 0};
    const glm::dvec3 n = normal / length;
    const double tilt = glm::degrees(std::asin(std::clamp(n.y, -1.0, 1.0)));
    constexpr double upright = 1e-6;
    if (std::hypot(n.x, n.z) < upright) return {heading, tilt};
    return {glm::degrees(std::atan2(n.x, n.z)), tilt};
}

SectionRectangle rectangleOf(const SectionPlane& plane, const Container& container) {
    const Bounds bounds = containerBounds(container);
    if (!plane.isFree())
        return {glm::dot(bounds.low, plane.right()), glm::dot(bounds.high, plane.right()),
                glm::dot(bounds.low, plane.up()), glm::dot(bounds.high, plane.up())};
    const glm::dvec3 half = 0.5 * (bounds.high - bounds.low);
    const auto* sphere = std::get_if<ContainerSphere>(&container);
    const auto reach = [&](const glm::dvec3& direction) {
        return sphere ? sphere->radius : glm::dot(half, glm::abs(direction));
    };
    const double across = reach(plane.right()), upwards = reach(plane.up());
    const glm::dvec2 middle = plane.footOf(centerOf(container));
    return {middle.x - across, middle.x + across, middle.y - upwards, middle.y + upwards};
}

SectionTravel travelOf(const SectionPlane& plane, const Container& container) {
    const Bounds bounds = containerBounds(container);
    if (!plane.isFree()) return {bounds.low[plane.axis()], bounds.high[plane.axis()]};
    const auto* sphere = std::get_if<ContainerSphere>(&container);
    const double reach =
        sphere ? sphere->radius : glm::dot(0.5 * (bounds.high - bounds.low), glm::abs(plane.normal()));
    return {-reach, reach};
}

std::vector<glm::dvec2> sectionOutline(const SectionPlane& plane, const Container& container) {
    if (const auto* sphere = std::get_if<ContainerSphere>(&container)) {
        constexpr int corners = 128;
        const glm::dvec2 foot = plane.footOf(sphere->center);
        const double distance = glm::distance(plane.at(foot.x, foot.y), sphere->center);
        if (distance > sphere->radius * (1 + 1e-12)) return {};
        const double radius = std::sqrt(std::max(0.0, sphere->radius * sphere->radius - distance * distance));
        std::vector<glm::dvec2> circle;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2 * M_PI * i / corners;
            circle.push_back(foot + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
        }
        return circle;
    }
    const SectionRectangle r = rectangleOf(plane, container);
    std::vector<glm::dvec2> polygon{
        {r.left, r.bottom}, {r.right, r.bottom}, {r.right, r.top}, {r.left, r.top}};
    const auto& box = std::get<ContainerBox>(container);
    for (int k = 0; k < 3; ++k) {
        polygon = clipped(polygon, plane, k, 1, box.high[k]);
        polygon = clipped(polygon, plane, k, -1, -box.low[k]);
    }
    // Corners that lie on a wall but for rounding come out twice.
    const double same = 1e-9 * (r.right - r.left + r.top - r.bottom);
    std::vector<glm::dvec2> corners;
    for (const glm::dvec2& corner : polygon)
        if (corners.empty() || glm::distance(corners.back(), corner) > same) corners.push_back(corner);
    if (corners.size() > 1 && glm::distance(corners.back(), corners.front()) <= same) corners.pop_back();
    polygon = std::move(corners);
    return polygon.size() < 3 ? std::vector<glm::dvec2>() : polygon;
}

}  // namespace isoscope
