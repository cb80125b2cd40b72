// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/contour/solid_field.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <new>

#include "core/evaluate/prepared_function.h"

namespace isoscope {

namespace {

/// From a point without a value to the one whose value it takes, by the size of the container; along no axis
/// and no diagonal, where functions are undefined together.
constexpr glm::dvec3 wayBeside(0.61e-9, 0.53e-9, 0.59e-9);

double& valueOf(double& value) { return value; }
double& valueOf(ValueAndGradient& here) { return here.value; }

}  // namespace

glm::dvec3 sizeOf(const Container& container) {
    if (const auto* sphere = std::get_if<ContainerSphere>(&container)) return glm::dvec3(2 * sphere->radius);
    const auto& box = std::get<ContainerBox>(container);
    return box.high - box.low;
}

SolidField::SolidField(const Isosurface& surface, std::span<const double> parameters)
    : function_(surface.prepared(parameters)),
      settings_(surface.rootSettings()),
      container_(surface.settings().container) {}

double SolidField::depth(const glm::dvec3& p) const {
    if (const auto* sphere = std::get_if<ContainerSphere>(&container_))
        return sphere->radius - glm::distance(p, sphere->center);
    const auto& box = std::get<ContainerBox>(container_);
    const glm::dvec3 inner = glm::min(p - box.low, box.high - p);
    const double least = std::min({inner.x, inner.y, inner.z});
    return least >= 0 ? least : -glm::length(glm::min(inner, glm::dvec3(0)));
}

glm::dvec3 SolidField::wallNormal(const glm::dvec3& p) const {
    if (const auto* sphere = std::get_if<ContainerSphere>(&container_)) {
        const glm::dvec3 arm = p - sphere->center;
        const double length = glm::length(arm);
        return length > 0 ? arm / length : glm::dvec3(1, 0, 0);
    }
    const auto& box = std::get<ContainerBox>(container_);
    glm::dvec3 normal(0);
    double nearest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k)
        for (const double side : {-1.0, 1.0}) {
            const double way = std::abs(p[k] - (side < 0 ? box.low[k] : box.high[k]));
            if (!(way < nearest)) continue;
            nearest = way;
            normal = glm::dvec3(0);
            normal[k] = side;
        }
    return normal;
}

glm::dvec3 SolidField::nearestInside(const glm::dvec3& p) const {
    if (const auto* sphere = std::get_if<ContainerSphere>(&container_)) {
        const double distance = glm::distance(p, sphere->center);
        if (distance <= sphere->radius) return p;
        return sphere->center + (p - sphere->center) * (sphere->radius * (1 - 1e-12) / distance);
    }
    const auto& box = std::get<ContainerBox>(container_);
    return glm::clamp(p, box.low, box.high);
}

double SolidField::exit(const glm::dvec3& from, const glm::dvec3& to) const {
    const glm::dvec3 way = to - from;
    double end = 1;
    if (const auto* sphere = std::get_if<ContainerSphere>(&container_)) {
        const glm::dvec3 arm = from - sphere->center;
        const double a = glm::dot(way, way), b = glm::dot(arm, way);
        const double c = glm::dot(arm, arm) - sphere->radius * sphere->radius;
        const double root = std::sqrt(std::max(0.0, b * b - a * c));
        // Of the two forms the one without cancellation.
        end = b > 0 ? -c / (b + root) : (root - b) / a;
    } else {
        const auto& box = std::get<ContainerBox>(container_);
        for (int k = 0; k < 3; ++k) {
            if (way[k] > 0) end = std::min(end, (box.high[k] - from[k]) / way[k]);
            if (way[k] < 0) end = std::min(end, (box.low[k] - from[k]) / way[k]);
        }
    }
    return std::isfinite(end) ? std::clamp(end, 0.0, 1.0) : 1;
}

bool SolidField::misses(const glm::dvec3& low, const glm::dvec3& high) const {
    if (const auto* sphere = std::get_if<ContainerSphere>(&container_)) {
        const glm::dvec3 nearest = glm::clamp(sphere->center, low, high);
        return glm::distance(nearest, sphere->center) > sphere->radius * (1 + 1e-12);
    }
    const auto& box = std::get<ContainerBox>(container_);
    for (int k = 0; k < 3; ++k)
        if (low[k] > box.high[k] || high[k] < box.low[k]) return true;
    return false;
}

bool SolidField::encloses(const glm::dvec3& low, const glm::dvec3& high) const {
    if (const auto* sphere = std::get_if<ContainerSphere>(&container_)) {
        const glm::dvec3 corner = glm::max(glm::abs(low - sphere->center), glm::abs(high - sphere->center));
        return glm::length(corner) < sphere->radius * (1 - 1e-12);
    }
    const auto& box = std::get<ContainerBox>(container_);
    for (int k = 0; k < 3; ++k)
        if (!(low[k] > box.low[k] && high[k] < box.high[k])) return false;
    return true;
}

SolidSampler::SolidSampler(const SolidField& field)
    : field_(field),
      boxes_(field.function(), field.settings()),
      points_(field.function().shared_from_this()),
      gradients_(field.function().shared_from_this()) {}

void SolidSampler::spread(std::span<const glm::dvec3> points) {
    x_.resize(points.size());
    y_.resize(points.size());
    z_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        x_[i] = points[i].x;
        y_[i] = points[i].y;
        z_[i] = points[i].z;
    }
}

void SolidSampler::values(std::span<const glm::dvec3> points, std::span<double> out,
                          const SimplifiedTape* tape) {
    spread(points);
    if (tape != nullptr)
        points_.evaluate(x_, y_, z_, out, *tape);
    else
        points_.evaluate(x_, y_, z_, out);
    for (double& value : out) value = field_.settings().signedValue(value);
    settleUndefined(points, out);
}

template <class Value>
void SolidSampler::settleUndefined(std::span<const glm::dvec3> points, std::span<Value> values) {
    std::vector<std::size_t> undefined;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (std::isnan(valueOf(values[i]))) undefined.push_back(i);
    if (undefined.empty()) return;
    std::vector<glm::dvec3> beside;
    for (const std::size_t i : undefined)
        beside.push_back(points[i] + sizeOf(field_.container()) * wayBeside);
    spread(beside);
    valuesBeside_.resize(beside.size());
    points_.evaluate(x_, y_, z_, valuesBeside_);
    for (std::size_t k = 0; k < undefined.size(); ++k) {
        const double g = field_.settings().signedValue(valuesBeside_[k]);
        valueOf(values[undefined[k]]) = std::isnan(g) ? std::numeric_limits<double>::infinity() : g;
    }
}

void SolidSampler::gradients(std::span<const glm::dvec3> points, std::span<ValueAndGradient> out) {
    spread(points);
    gradients_.evaluate(x_, y_, z_, out);
    for (ValueAndGradient& here : out) {
        here.value = field_.settings().signedValue(here.value);
        if (!field_.settings().positivePolarity) continue;
        for (double& slope : here.gradient) slope = -slope;
    }
    settleUndefined(points, out);
}

void SolidSampler::inside(std::span<const glm::dvec3> points, std::span<std::uint8_t> out, bool anywhere) {
    values_.resize(points.size());
    values(points, values_);
    for (std::size_t i = 0; i < points.size(); ++i)
        out[i] = countsInside(values_[i]) && (anywhere || field_.depth(points[i]) >= 0) ? 1 : 0;
}

std::unique_ptr<SolidSampler> SamplerPool::take() {
    {
        const std::lock_guard lock(mutex_);
        if (!idle_.empty()) {
            std::unique_ptr<SolidSampler> sampler = std::move(idle_.back());
            idle_.pop_back();
            return sampler;
        }
    }
    return std::make_unique<SolidSampler>(field_);
}

void SamplerPool::giveBack(std::unique_ptr<SolidSampler> sampler) noexcept {
    const std::lock_guard lock(mutex_);
    try {
        idle_.push_back(std::move(sampler));
    } catch (const std::bad_alloc&) {
        // Another one is made where there is memory again.
    }
}

}  // namespace isoscope
