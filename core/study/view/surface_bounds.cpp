// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/surface_bounds.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/shapes/combined/bounded_shape.h"
#include "core/shapes/combined/clipped_shape.h"
#include "core/shapes/combined/csg.h"
#include "core/shapes/combined/inverse_shape.h"
#include "core/shapes/combined/placed_shape.h"
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

double reachOf(const Torus& torus, const glm::dvec3& n) {
    return std::abs(torus.major()) * std::hypot(n.x, n.z) + std::abs(torus.minor()) * glm::length(n);
}

double reachOf(const Cone& cone, const glm::dvec3& n) {
    const glm::dvec3 base = cone.base(), cap = cone.cap(), axis = cap - base;
    const double length = glm::length(axis);
    if (!(length > 0)) return -infinity;
    const double across = glm::length(n - axis * (glm::dot(n, axis) / (length * length)));
    return std::max(glm::dot(n, base) + across * cone.baseRadius(),
                    glm::dot(n, cap) + across * cone.capRadius());
}

/// What cuts something away limits nothing by itself.
bool isInverse(const ShapePointer& shape) {
    if (const auto* placed = dynamic_cast<const PlacedShape*>(shape.get())) return isInverse(placed->shape());
    return dynamic_cast<const InverseShape*>(shape.get()) != nullptr;
}

bool ends(const ShapePointer& shape) { return shape->boundsWithin({}).finite(); }

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
        if (!object.shape->boundsWithin({}).contains(scene_->camera.location)) shown_.push_back(object.shape);
    }
    if (shown_.empty()) shown_ = finite.empty() ? std::move(visible) : std::move(finite);
}

double SurfaceBounds::reach(const glm::dvec3& direction) {
    // What may go farthest comes first: most of the others need no look then.
    std::vector<std::pair<double, const ShapePointer*>> order;
    for (const ShapePointer& shape : shown_)
        order.emplace_back(reachOf(shape->boundsWithin({}), direction), &shape);
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
    const double limit = isInverse(shape) ? infinity : reachOf(shape->boundsWithin({}), direction);
    if (limit <= known) return limit;
    if (const auto surface = std::dynamic_pointer_cast<const Isosurface>(shape)) {
        auto& study = isosurfaces_[surface.get()];
        if (!study) study = std::make_unique<IsosurfaceReach>(surface, *scene_->parameterTable, settings_);
        return study->along(direction, stop_);
    }
    if (const auto* placed = dynamic_cast<const PlacedShape*>(shape.get())) {
        const glm::dmat4& m = placed->transform().forward();
        const double shift = glm::dot(direction, glm::dvec3(m[3]));
        const glm::dvec3 inner(glm::dot(direction, glm::dvec3(m[0])), glm::dot(direction, glm::dvec3(m[1])),
                               glm::dot(direction, glm::dvec3(m[2])));
        return shift + reach(placed->shape(), inner, known - shift);
    }
    if (const auto* csg = dynamic_cast<const Csg*>(shape.get())) return reachOfParts(*csg, direction, known);
    if (const auto* inverse = dynamic_cast<const InverseShape*>(shape.get()))
        return reach(inverse->shape(), direction, known);
    if (const auto* bounded = dynamic_cast<const BoundedShape*>(shape.get()))
        return std::min(limit, reach(bounded->shape(), direction, known));
    if (const auto* clipped = dynamic_cast<const ClippedShape*>(shape.get())) {
        double reached = std::min(limit, reach(clipped->shape(), direction, known));
        for (const ShapePointer& clip : clipped->clips())
            if (!isInverse(clip)) reached = std::min(reached, reach(clip, direction, known));
        return reached;
    }
    if (const auto* sphere = dynamic_cast<const Sphere*>(shape.get()))
        return glm::dot(direction, sphere->center()) + sphere->radius() * glm::length(direction);
    if (const auto* torus = dynamic_cast<const Torus*>(shape.get())) return reachOf(*torus, direction);
    if (const auto* cone = dynamic_cast<const Cone*>(shape.get())) return reachOf(*cone, direction);
    return limit;
}

double SurfaceBounds::reachOfParts(const Csg& csg, const glm::dvec3& direction, double known) {
    const bool grows = csg.operation() == CsgOperation::union_ || csg.operation() == CsgOperation::merge;
    double reached = grows ? -infinity : reachOf(csg.boundsWithin({}), direction);
    for (const ShapePointer& part : csg.parts()) {
        if (grows)
            reached = std::max(reached, reach(part, direction, std::max(known, reached)));
        else if (!isInverse(part) && reached > known)
            reached = std::min(reached, reach(part, direction, known));
    }
    return reached;
}

}  // namespace isoscope
