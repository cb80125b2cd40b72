// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/shape/surface_points.h"

#include <algorithm>
#include <limits>

#include "core/shapes/hit.h"
#include "core/shapes/rays/ray.h"
#include "core/shapes/trace_context.h"
#include "core/study/gradient/gradient_domain.h"

namespace isoscope {

namespace {

constexpr int mostRoots = 10;

}  // namespace

Isosurface withAllRoots(const Isosurface& surface) {
    IsosurfaceSettings settings = surface.settings();
    settings.maxTrace = mostRoots;
    return Isosurface(std::move(settings));
}

std::vector<glm::dvec3> surfacePoints(const Isosurface& surface, std::span<const double> parameters,
                                      int raysAlong, std::size_t most, std::stop_token stop) {
    const GradientDomain domain(surface.settings().container);
    if (domain.empty() || raysAlong < 1) return {};
    const Isosurface all = withAllRoots(surface);
    TraceContext context(std::make_shared<const std::vector<double>>(parameters.begin(), parameters.end()),
                         RootFinder::certified);
    context.stop = stop;
    const glm::dvec3 low = domain.box().low, extent = domain.box().high - low;
    std::vector<glm::dvec3> points;
    // All rays along an axis together: a search has room for many lines.
    std::vector<Ray> rays;
    std::vector<HitList> hits(static_cast<std::size_t>(raysAlong) * static_cast<std::size_t>(raysAlong));
    for (int axis = 0; axis < 3 && !stop.stop_requested(); ++axis) {
        rays.clear();
        for (int i = 0; i < raysAlong; ++i)
            for (int j = 0; j < raysAlong; ++j) {
                // Not in the middle: there symmetric functions have edges and poles.
                glm::dvec3 share(0);
                share[(axis + 1) % 3] = (i + 0.47) / raysAlong;
                share[(axis + 2) % 3] = (j + 0.53) / raysAlong;
                Ray ray{low + share * extent, glm::dvec3(0)};
                ray.direction[axis] = 1;
                ray.origin[axis] -= 0.01 * extent[axis];
                rays.push_back(ray);
            }
        all.allHits(rays, context, hits);
        for (const HitList& found : hits)
            for (const Hit& hit : found)
                if (hit.kind == HitKind::crossing) points.push_back(hit.point);
    }
    if (points.size() <= most) return points;
    std::vector<glm::dvec3> some;
    for (std::size_t i = 0; i < most; ++i) some.push_back(points[i * points.size() / most]);
    return some;
}

}  // namespace isoscope
