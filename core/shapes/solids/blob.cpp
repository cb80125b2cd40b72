// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/solids/blob.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/shapes/rays/hit_list.h"

namespace isoscope {

namespace {

/// A field this much below the threshold still counts as inside, as in POV-Ray: where surfaces coincide in
/// CSG it decides what shows.
constexpr double skin = 1e-6;

/// Where a ray along a plane stops to see it.
constexpr double planeReach = 2 * farthestDistance;

Bounds reachOf(const BlobComponent& component) {
    if (component.plane) return {};
    const glm::dvec3 radius(component.radius);
    const Bounds own{glm::min(component.from, component.to) - radius,
                     glm::max(component.from, component.to) + radius};
    return transform(own, component.transform.forward());
}

/// The nearest point of the component's line or plane, in its own coordinates.
glm::dvec3 coreOf(const BlobComponent& component, const glm::dvec3& point) {
    if (component.plane)
        return point - (glm::dot(component.from, point) - component.distance) * component.from;
    const glm::dvec3 axis = component.to - component.from;
    const double square = glm::dot(axis, axis);
    if (!(square > 0)) return component.from;
    return component.from + std::clamp(glm::dot(point - component.from, axis) / square, 0.0, 1.0) * axis;
}

}  // namespace

Blob::Blob(std::vector<BlobComponent> components, double threshold, RootChoice choice)
    : components_(std::move(components)), threshold_(threshold), choice_(choice) {
    bounds_ = {glm::dvec3(0), glm::dvec3(0)};
    bool first = true;
    std::vector<Bounds> finite;
    for (BlobComponent& component : components_) {
        component.radius = std::abs(component.radius);
        (component.plane ? planes_ : inTree_).push_back(reaches_.size());
        reaches_.push_back(reachOf(component));
        if (!component.plane) finite.push_back(reaches_.back());
        if (!(component.strength > 0)) continue;
        bounds_ = first ? reaches_.back() : unite(bounds_, reaches_.back());
        first = false;
    }
    if (bounds_.finite()) center_ = (bounds_.low + bounds_.high) / 2.0;
    tree_ = Bvh(finite);
}

void Blob::intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const {
    ++context.rays;
    const CenteredRay line(ray, center_);
    if (!line.usable) return;
    std::vector<Stretch> stretches;
    tree_.visit(ray, {}, [&](std::size_t i, double far) {
        addStretches(components_[inTree_[i]], line, stretches);
        return far;
    });
    for (const std::size_t i : planes_) addStretches(components_[i], line, stretches);
    std::vector<double> ends;
    for (const Stretch& stretch : stretches) {
        ends.push_back(stretch.from);
        ends.push_back(stretch.to);
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    RootSequence roots;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        const double middle = ends[k] + (ends[k + 1] - ends[k]) / 2;
        std::array<double, 5> quartic{0, 0, 0, 0, -threshold_};
        double most = 0;
        for (const Stretch& q : stretches) {
            if (!(q.from < middle && middle < q.to)) continue;
            most += std::max(q.strength, 0.0);
            const double c = q.c - 1;
            quartic[0] += q.strength * q.a * q.a;
            quartic[1] += q.strength * 2 * q.a * q.b;
            quartic[2] += q.strength * (q.b * q.b + 2 * q.a * c);
            quartic[3] += q.strength * 2 * q.b * c;
            quartic[4] += q.strength * c * c;
        }
        if (!(most > threshold_)) continue;
        chosenRoots(choice_, quartic, ends[k], ends[k + 1], roots);
        for (const double s : roots) {
            const double t = line.toRay(s);
            if (interval.near <= t && t <= interval.far)
                hits.push_back({t, ray.at(t), normalAt(line.at(s) + center_)});
        }
    }
}

void Blob::addStretches(const BlobComponent& component, const CenteredRay& line,
                        std::vector<Stretch>& stretches) const {
    const Transform back = component.transform.inverse();
    const glm::dvec3 o = back.point(line.origin + center_), d = back.direction(line.direction);
    const double scale = 1 / (component.radius * component.radius);
    // q of the distance from a point, or from a line along `axis` through it, cut to [from, to].
    const auto add = [&](const glm::dvec3& arm, const glm::dvec3& speed, double from, double to) {
        Stretch q{from,
                  to,
                  scale * glm::dot(speed, speed),
                  2 * scale * glm::dot(arm, speed),
                  scale * glm::dot(arm, arm),
                  component.strength};
        if (q.a > 0) {
            RootSequence ends;
            realRoots(std::array<double, 3>{q.a, q.b, q.c - 1}, -1e15, 1e15, ends);
            if (ends.size() < 2) return;
            q.from = std::max(from, ends[0]);
            q.to = std::min(to, ends[1]);
        } else if (!(q.c < 1)) {
            return;
        }
        if (q.from < q.to && std::isfinite(q.from) && std::isfinite(q.to)) stretches.push_back(q);
    };
    if (component.plane) {
        const double height = glm::dot(o, component.from) - component.distance;
        return add(height * component.from, glm::dot(d, component.from) * component.from, -planeReach,
                   planeReach);
    }
    const glm::dvec3 axis = component.to - component.from;
    const double length = glm::length(axis);
    if (!(length > 0)) return add(o - component.from, d, -INFINITY, INFINITY);
    const glm::dvec3 unit = axis / length;
    const double height = glm::dot(o - component.from, unit), climb = glm::dot(d, unit);
    const auto across = [&](const glm::dvec3& v) { return v - glm::dot(v, unit) * unit; };
    if (climb == 0) {
        if (height < 0) return add(o - component.from, d, -INFINITY, INFINITY);
        if (height > length) return add(o - component.to, d, -INFINITY, INFINITY);
        return add(across(o - component.from), across(d), -INFINITY, INFINITY);
    }
    const double atBase = -height / climb, atCap = (length - height) / climb;
    const double first = std::min(atBase, atCap), last = std::max(atBase, atCap);
    add(o - (climb > 0 ? component.from : component.to), d, -INFINITY, first);
    add(across(o - component.from), across(d), first, last);
    add(o - (climb > 0 ? component.to : component.from), d, last, INFINITY);
}

double Blob::fieldOf(std::size_t i, const glm::dvec3& point) const {
    if (!reaches_[i].contains(point)) return 0;
    const BlobComponent& component = components_[i];
    const glm::dvec3 own = component.transform.inverse().point(point);
    const glm::dvec3 arm = own - coreOf(component, own);
    const double rest = 1 - glm::dot(arm, arm) / (component.radius * component.radius);
    return rest > 0 ? component.strength * rest * rest : 0;
}

double Blob::fieldAt(const glm::dvec3& point) const {
    double field = 0;
    for (std::size_t i = 0; i < components_.size(); ++i) field += fieldOf(i, point);
    return field;
}

std::vector<TextureShare> Blob::textureShares(const glm::dvec3& point) const {
    std::vector<TextureShare> shares;
    double total = 0;
    for (std::size_t i = 0; i < components_.size(); ++i) {
        const double field = std::abs(fieldOf(i, point));
        if (!(field > 0)) continue;
        shares.push_back({components_[i].texture, field});
        total += field;
    }
    if (!(total > 0)) return {{0, 1}};
    for (TextureShare& share : shares) share.share /= total;
    return shares;
}

glm::dvec3 Blob::normalAt(const glm::dvec3& point) const {
    glm::dvec3 normal(0);
    for (const BlobComponent& component : components_) {
        const glm::dvec3 own = component.transform.inverse().point(point);
        const glm::dvec3 arm = own - coreOf(component, own);
        const double scale = 1 / (component.radius * component.radius), rest = 1 - glm::dot(arm, arm) * scale;
        if (rest > 0) normal += component.transform.normal(arm * (component.strength * rest * scale));
    }
    return unitNormal(normal);
}

bool Blob::contains(const glm::dvec3& point, TraceContext&) const {
    return bounds_.contains(point) && fieldAt(point) > threshold_ - skin;
}

}  // namespace isoscope
