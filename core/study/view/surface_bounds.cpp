// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/surface_bounds.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/shapes/composition.h"
#include "core/shapes/solids/cone.h"
#include "core/shapes/solids/sphere.h"
#include "core/shapes/solids/torus.h"

namespace isoscope {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double reachOf(const Bounds& box, const glm::dvec3& direction) {
    double reach = 0;
    for (int k = 0; k < 3; ++k)
        if (direction[k] != 0) reach += direction[k] * (direction[k] < 0 ? box.low[k] : box.high[k]);
    return isEmpty(box) ? -infinity : reach;
}

double reachOf(const Sphere& sphere, const glm::dvec3& direction) {
    return glm::dot(direction, sphere.center()) + sphere.radius() * glm::length(direction);
}

double reachOf(const Torus& torus, const glm::dvec3& direction) {
    return std::abs(torus.major()) * std::hypot(direction.x, direction.z) +
           std::abs(torus.minor()) * glm::length(direction);
}

double reachOf(const Cone& cone, const glm::dvec3& direction) {
    const glm::dvec3 base = cone.base(), cap = cone.cap(), axis = cap - base;
    const double length = glm::length(axis);
    if (!(length > 0)) return -infinity;
    const glm::dvec3 along = axis * (glm::dot(direction, axis) / (length * length));
    const double across = glm::length(direction - along);
    return std::max(glm::dot(direction, base) + across * cone.baseRadius(),
                    glm::dot(direction, cap) + across * cone.capRadius());
}

/// How far a primitive reaches along a direction: balls, tori and cones exactly, others by their limit.
double reachOf(const PrimitivePointer& primitive, const glm::dvec3& direction, double limit) {
    double reach = limit;
    primitive.visit<Sphere, Torus, Cone>([&](const auto& known) { reach = reachOf(known, direction); });
    return reach;
}

/// What cuts something away limits nothing by itself, moved or limited as it may be.
bool isInverse(const ShapePointer& shape) {
    using enum Composition::Kind;
    const Composition made = shape->composition();
    return made.kind == complement || (made.kind == wrapped && isInverse(made.parts.front()));
}

/// A box around the surface.
Bounds boundsOf(const ShapePointer& shape) { return shape->boundsWithin(shape->bounds()); }

bool ends(const ShapePointer& shape) { return boundsOf(shape).finite(); }

}  // namespace

bool isEmpty(const Bounds& bounds) {
    return !(bounds.low.x <= bounds.high.x && bounds.low.y <= bounds.high.y && bounds.low.z <= bounds.high.z);
}

SurfaceBounds::SurfaceBounds(std::shared_ptr<const Scene> scene, ReachSettings settings, std::stop_token stop)
    : scene_(std::move(scene)), settings_(settings), stop_(std::move(stop)) {
    std::vector<ShapePointer> visible, finite;
    for (const SceneObject& object : scene_->objects) {
        if (!object.visible || !object.shape) continue;
        visible.push_back(object.shape);
        if (!ends(object.shape)) continue;
        finite.push_back(object.shape);
        if (!boundsOf(object.shape).contains(scene_->camera.location)) shown_.push_back(object.shape);
    }
    if (shown_.empty()) shown_ = finite.empty() ? std::move(visible) : std::move(finite);
}

double SurfaceBounds::reach(const glm::dvec3& direction) {
    // What may go farthest comes first: most of the others need no look then.
    std::vector<std::pair<double, const ShapePointer*>> order;
    for (const ShapePointer& shape : shown_) order.emplace_back(reachOf(boundsOf(shape), direction), &shape);
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    double farthest = -infinity;
    for (const auto& [limit, shape] : order) {
        if (limit <= farthest) break;
        farthest = std::max(farthest, std::min(limit, reach(*shape, direction, farthest)));
    }
    return farthest;
}

Bounds SurfaceBounds::box() {
    Bounds box;
    for (int k = 0; k < 3; ++k) {
        glm::dvec3 axis(0);
        axis[k] = 1;
        box.high[k] = reach(axis);
        box.low[k] = -reach(-axis);
    }
    return box;
}

std::uint64_t SurfaceBounds::boxes() const {
    std::uint64_t all = 0;
    for (const auto& [surface, reach] : isosurfaces_) all += reach->boxes();
    return all;
}

/// At least min(the reach, `known`): what reaches no farther than is known already does not matter.
double SurfaceBounds::reach(const ShapePointer& shape, const glm::dvec3& direction, double known) {
    const double limit = reachOf(boundsOf(shape), direction);
    if (limit <= known) return limit;
    if (const auto surface = asIsosurface(shape)) {
        auto& study = isosurfaces_[surface.get()];
        if (!study) study = std::make_unique<IsosurfaceReach>(surface, *scene_->parameterTable, settings_);
        return study->along(direction, stop_);
    }
    using enum Composition::Kind;
    const Composition made = shape->composition();
    if (made.kind == primitive) return reachOf(shape->primitive(), direction, limit);
    if (made.kind == complement) return reach(made.parts.front(), direction, known);
    if (made.kind != wrapped) return reachOfParts(made, direction, known, limit);
    if (made.transform == nullptr) return reachOfWrapped(made, direction, known, limit);
    const glm::dmat4& m = made.transform->forward();
    const double shift = glm::dot(direction, glm::dvec3(m[3]));
    const glm::dvec3 inner(glm::dot(direction, glm::dvec3(m[0])), glm::dot(direction, glm::dvec3(m[1])),
                           glm::dot(direction, glm::dvec3(m[2])));
    return shift + reachOfWrapped(made, inner, known - shift, limit - shift);
}

double SurfaceBounds::reachOfWrapped(const Composition& made, const glm::dvec3& direction, double known,
                                     double limit) {
    double reached = reach(made.parts.front(), direction, known);
    if (!made.limits.empty()) reached = std::min(limit, reached);
    if (!made.limitsCut) return reached;
    for (const ShapePointer& clip : made.limits)
        if (!isInverse(clip)) reached = std::min(reached, reach(clip, direction, known));
    return reached;
}

double SurfaceBounds::reachOfParts(const Composition& made, const glm::dvec3& direction, double known,
                                   double limit) {
    const bool grows = made.kind != Composition::Kind::intersection;
    double reached = grows ? -infinity : limit;
    for (const ShapePointer& part : made.parts) {
        if (grows)
            reached = std::max(reached, reach(part, direction, std::max(known, reached)));
        else if (!isInverse(part) && reached > known)
            reached = std::min(reached, reach(part, direction, known));
    }
    return reached;
}

}  // namespace isoscope
