// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/point_evaluator.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/shapes/hit.h"
#include "core/shapes/rays/ray.h"
#include "core/shapes/trace_context.h"
#include "core/study/gradient/gradient_domain.h"
#include "core/study/gradient/spread_points.h"
#include "core/study/shape/shape_measures.h"
#include "core/study/shape/surface_points.h"

namespace isoscope {

namespace {

constexpr std::size_t symmetryPoints = 4096;
constexpr int raysAlong = 24;
constexpr std::size_t mostPoints = 2000;
/// How far outside of the surface rays begin, in parts of accuracy: much more than roots are off.
constexpr double startShare = 0.25;

struct Movement {
    const char* name;
    std::function<glm::dvec3(const glm::dvec3&)> move;  ///< about the origin
};

std::vector<Movement> movements() {
    using V = glm::dvec3;
    return {
        {"mirror x", [](const V& p) { return V(-p.x, p.y, p.z); }},
        {"mirror y", [](const V& p) { return V(p.x, -p.y, p.z); }},
        {"mirror z", [](const V& p) { return V(p.x, p.y, -p.z); }},
        {"half turn about x", [](const V& p) { return V(p.x, -p.y, -p.z); }},
        {"half turn about y", [](const V& p) { return V(-p.x, p.y, -p.z); }},
        {"half turn about z", [](const V& p) { return V(-p.x, -p.y, p.z); }},
        {"point", [](const V& p) { return -p; }},
        {"x and y exchanged", [](const V& p) { return V(p.y, p.x, p.z); }},
        {"y and z exchanged", [](const V& p) { return V(p.x, p.z, p.y); }},
        {"z and x exchanged", [](const V& p) { return V(p.z, p.y, p.x); }},
        {"any turn about x", [](const V& p) { return V(p.x, 0.6 * p.y - 0.8 * p.z, 0.8 * p.y + 0.6 * p.z); }},
        {"any turn about y",
         [](const V& p) { return V(0.6 * p.x + 0.8 * p.z, p.y, -0.8 * p.x + 0.6 * p.z); }},
        {"any turn about z", [](const V& p) { return V(0.6 * p.x - 0.8 * p.y, 0.8 * p.x + 0.6 * p.y, p.z); }},
    };
}

}  // namespace

ThinnestWall thinnestWall(const Isosurface& surface, std::span<const double> parameters,
                          std::stop_token stop) {
    ThinnestWall wall;
    const LoopStop loops(stop);
    const Isosurface all = withAllRoots(surface);
    GradientEvaluator gradients(surface.prepared(parameters));
    TraceContext context(std::make_shared<const std::vector<double>>(parameters.begin(), parameters.end()),
                         RootFinder::certified);
    context.stop = stop;
    const double sign = surface.settings().positivePolarity ? 1 : -1;
    const double before = startShare * surface.rootSettings().accuracy;
    wall.thickness = std::numeric_limits<double>::infinity();
    HitList hits;
    for (const glm::dvec3& place : surfacePoints(surface, parameters, raysAlong, mostPoints, stop)) {
        if (stop.stop_requested()) return {};
        const ValueAndGradient at = gradients.evaluate(place.x, place.y, place.z);
        const glm::dvec3 slope(at.gradient[0], at.gradient[1], at.gradient[2]);
        const double steepness = glm::length(slope);
        if (!(steepness > 0) || !std::isfinite(steepness)) continue;
        const glm::dvec3 inwards = sign * slope / steepness;
        // From outside, so that the surface itself is the first hit.
        const Ray ray{place - before * inwards, inwards};
        hits.clear();
        all.intersect(ray, {0, std::numeric_limits<double>::infinity()}, context, hits);
        if (hits.size() < 2 || hits[0].t > 2 * before) continue;
        ++wall.measured;
        const double thickness = hits[1].t - hits[0].t;
        if (thickness < wall.thickness) wall.thickness = thickness, wall.place = hits[0].point;
    }
    if (wall.measured == 0) wall.thickness = 0;
    return wall;
}

std::vector<Symmetry> symmetriesOf(const Isosurface& surface, std::span<const double> parameters,
                                   double tolerance) {
    const GradientDomain domain(surface.settings().container);
    if (domain.empty()) return {};
    PointEvaluator values(surface.prepared(parameters));
    const glm::dvec3 center = domain.box().center();
    const SpreadPoints points = spreadPoints(domain, symmetryPoints);
    std::vector<double> here(points.x.size()), there(points.x.size());
    values.evaluate(points.x, points.y, points.z, here);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double value : here)
        if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    if (!(high > low)) return {};
    std::vector<Symmetry> all;
    for (const Movement& movement : movements()) {
        SpreadPoints moved;
        for (std::size_t i = 0; i < points.x.size(); ++i)
            moved.add(center + movement.move(glm::dvec3(points.x[i], points.y[i], points.z[i]) - center));
        values.evaluate(moved.x, moved.y, moved.z, there);
        double error = 0;
        for (std::size_t i = 0; i < here.size() && error <= tolerance; ++i) {
            if (std::isnan(here[i]) && std::isnan(there[i])) continue;
            if (here[i] == there[i]) continue;
            const double differs = std::abs(here[i] - there[i]) / (high - low);
            error =
                std::isfinite(differs) ? std::max(error, differs) : std::numeric_limits<double>::infinity();
        }
        if (error <= tolerance) all.push_back({movement.name, error});
    }
    return all;
}

}  // namespace isoscope
