// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/ray_profile.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <memory>

#include "core/evaluate/tape/loop_stop.h"
#include "core/roots/certified/certified_root_finder.h"
#include "core/roots/lipschitz/tape_field.h"
#include "core/shapes/rays/line_interval.h"

namespace isoscope {

namespace {

LineInterval insideOf(const Container& container, const Ray& ray) {
    if (const auto* box = std::get_if<ContainerBox>(&container)) return boxInterval(ray, box->low, box->high);
    const auto& sphere = std::get<ContainerSphere>(container);
    return sphereInterval(ray, sphere.center, sphere.radius);
}

std::vector<ProfilePoint> curveOf(TapeField& field, const LineQuery& line, const RootSettings& settings,
                                  int count) {
    std::vector<double> x, y, z, values(static_cast<std::size_t>(count));
    std::vector<ProfilePoint> curve;
    for (int k = 0; k < count; ++k) {
        const double t = line.near + (line.far - line.near) * k / (count - 1);
        const glm::dvec3 p = line.origin + t * line.direction;
        x.push_back(p.x), y.push_back(p.y), z.push_back(p.z);
        curve.push_back({t, 0});
    }
    field.values(x, y, z, values);
    for (std::size_t k = 0; k < curve.size(); ++k) curve[k].value = settings.signedValue(values[k]);
    return curve;
}

constexpr int mostRoots = 10;

}  // namespace

bool RayProfile::wronglyPruned(const SearchedInterval& interval) const {
    if (interval.fate != IntervalFate::pruned) return false;
    return std::any_of(certifiedRoots.begin(), certifiedRoots.end(), [&](const Root& root) {
        const bool wall = root.kind == RootKind::entryWall || root.kind == RootKind::exitWall;
        return !wall && root.t > interval.low && root.t < interval.high;
    });
}

RayProfile profileOf(const Scene& scene, std::size_t isosurface, const Ray& worldRay, int curvePoints,
                     std::stop_token stop) {
    RayProfile profile;
    const LoopStop loops(stop);
    if (isosurface >= scene.isosurfaces.size() || !scene.isosurfaces[isosurface].shape) return profile;
    const SceneIsosurface& placed = scene.isosurfaces[isosurface];
    const Isosurface& surface = *placed.shape;
    const RootSettings& settings = surface.rootSettings();
    const Ray ray = placed.transform.toObject(worldRay);
    profile.maxGradient = settings.maxGradient * glm::length(ray.direction);
    profile.accuracy = settings.accuracy;
    const LineInterval inside = insideOf(surface.settings().container, ray);
    const double near = std::max(0.0, inside.range.near);
    if (!(near < inside.range.far)) return profile;
    profile.meetsContainer = true;
    profile.near = near;
    profile.far = inside.range.far;
    const LineQuery line{ray.origin, ray.direction, profile.near, profile.far};
    const auto function = surface.prepared(*scene.parameterTable);
    TapeField field(function);
    if (stop.stop_requested()) return {};
    profile.curve = curveOf(field, line, settings, std::max(2, curvePoints));
    profile.povray = explainSearch(line, settings, [&](double t) {
        const glm::dvec3 p = line.origin + t * line.direction;
        double value = 0;
        field.values(std::span(&p.x, 1), std::span(&p.y, 1), std::span(&p.z, 1), std::span(&value, 1));
        return value;
    });
    RootSettings all = settings;
    all.maxTrace = mostRoots;
    CertifiedRootFinder certified(function, all);
    RootRequest request;
    request.stop = stop;
    certified.find(std::span(&line, 1), request, std::span(&profile.certifiedRoots, 1));
    profile.enclosures = encloseRay(function, settings, line);
    return profile;
}

}  // namespace isoscope
