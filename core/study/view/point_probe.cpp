// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/point_probe.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>

#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/study/view/surface_distance.h"

namespace isoscope {

namespace {

/// A share of the container by which a point on its wall may lie outside, and of a distance by which a point
/// on a surface may lie behind it: both were found by root finders.
constexpr double slack = 1e-3;

bool holds(const Container& container, const glm::dvec3& place) {
    if (const auto* box = std::get_if<ContainerBox>(&container)) {
        const glm::dvec3 rim = slack * (box->high - box->low);
        return glm::all(glm::greaterThanEqual(place, box->low - rim)) &&
               glm::all(glm::lessThanEqual(place, box->high + rim));
    }
    const auto& sphere = std::get<ContainerSphere>(container);
    return glm::distance(place, sphere.center) <= sphere.radius * (1 + slack);
}

bool finite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

}  // namespace

double ProbedPoint::distance() const { return surfaceDistance(value - threshold, slope); }

PointProbe::PointProbe(std::shared_ptr<const Scene> scene)
    : scene_(std::move(scene)), objects_(*scene_, [](const SceneObject& object) { return object.visible; }) {}

std::optional<ProbedPoint> PointProbe::at(std::size_t isosurface, const glm::dvec3& place,
                                          std::stop_token stop) const {
    if (isosurface >= scene_->isosurfaces.size() || !finite(place)) return {};
    const SceneIsosurface& placed = scene_->isosurfaces[isosurface];
    if (!placed.shape) return {};
    const LoopStop loops(stop);
    const ValueAndGradient found =
        GradientEvaluator(placed.shape->tape(), *scene_->parameterTable).evaluate(place.x, place.y, place.z);
    if (stop.stop_requested()) return {};
    ProbedPoint point;
    point.isosurface = isosurface;
    point.place = place;
    point.inScene = placed.transform.point(place);
    point.value = found.value;
    point.slope = slopeOf(found);
    point.threshold = placed.shape->settings().threshold;
    point.maxGradient = placed.shape->rootSettings().maxGradient;
    point.contained = holds(placed.shape->settings().container, place);
    return point;
}

std::optional<double> PointProbe::firstHit(const Ray& ray, const std::stop_token& stop) const {
    TraceContext context(scene_->parameterTable, RootFinder::certified);
    context.stop = stop;
    const LoopStop loops(stop);
    GatheredRays gathered;
    NearestHit nearest;
    objects_.nearest(std::span(&ray, 1), context, gathered, std::span(&nearest, 1));
    if (!nearest.found || stop.stop_requested()) return {};
    return nearest.hit.t;
}

std::optional<ProbedPoint> PointProbe::seenAlong(const Ray& ray, std::stop_token stop) const {
    const auto hit = firstHit(ray, stop);
    if (!hit) return {};
    const glm::dvec3 seen = ray.origin + *hit * ray.direction;
    std::optional<ProbedPoint> best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < scene_->isosurfaces.size(); ++i) {
        const auto point = at(i, scene_->isosurfaces[i].transform.inversePoint(seen), stop);
        if (!point || !point->contained) continue;
        const double away = std::abs(point->distance());
        if (best && !(away < least)) continue;
        least = std::isnan(away) ? std::numeric_limits<double>::infinity() : away;
        best = point;
    }
    return best;
}

bool PointProbe::hides(const Ray& ray, const glm::dvec3& point, std::stop_token stop) const {
    const auto hit = firstHit(ray, stop);
    return hit && *hit < nearestOnRay(ray, point) * (1 - slack);
}

double nearestOnRay(const Ray& ray, const glm::dvec3& point) {
    const double square = glm::dot(ray.direction, ray.direction);
    return square > 0 ? glm::dot(point - ray.origin, ray.direction) / square : 0;
}

}  // namespace isoscope
