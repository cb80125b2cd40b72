// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/gradient_heat_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/study/gradient/hole_map.h"

namespace isoscope {

namespace {

constexpr float unseen = std::numeric_limits<float>::quiet_NaN();

/// Points gathered for one call of the evaluator, with the pixels that they belong to.
struct Points {
    std::vector<double> x, y, z;
    std::vector<std::size_t> pixels;
};

Points pointsOf(const RenderRequest& request, const TracedView& truth, const SceneIsosurface& placed) {
    Points points;
    const Transform toObject = placed.transform.inverse();
    for (int y = 0; y < truth.height; ++y)
        for (int x = 0; x < truth.width; ++x) {
            const std::size_t index = static_cast<std::size_t>(y) * static_cast<std::size_t>(truth.width) +
                                      static_cast<std::size_t>(x);
            const TracedPixel& pixel = truth.pixels[index];
            // Walls of the container do not lie on the level set.
            if (!pixel.found || pixel.kind != HitKind::crossing) continue;
            const glm::dvec3 p = toObject.point(pixelRay(request, x, y).at(pixel.t));
            points.x.push_back(p.x), points.y.push_back(p.y), points.z.push_back(p.z);
            points.pixels.push_back(index);
        }
    return points;
}

}  // namespace

std::vector<double> slopesOnSurface(const RenderRequest& request, const TracedView& truth,
                                    std::size_t isosurface, double tolerance) {
    std::vector<double> slopes(truth.pixels.size(), std::numeric_limits<double>::quiet_NaN());
    if (!request.scene || isosurface >= request.scene->isosurfaces.size()) return slopes;
    const SceneIsosurface& placed = request.scene->isosurfaces[isosurface];
    if (!placed.shape) return slopes;
    const Points points = pointsOf(request, truth, placed);
    std::vector<ValueAndGradient> found(points.pixels.size());
    GradientEvaluator(placed.shape->prepared(*request.scene->parameterTable))
        .evaluate(points.x, points.y, points.z, found);
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double slope = slopeOf(found[i]);
        // Hits of other objects do not lie on the level set.
        const double off = std::abs(found[i].value - placed.shape->rootSettings().threshold);
        if (off <= slope * tolerance + 1e-12) slopes[points.pixels[i]] = slope;
    }
    return slopes;
}

GradientHeatMap gradientHeatMap(RenderRequest request, int threads, std::stop_token stop,
                                const ShareReport& report) {
    GradientHeatMap map;
    if (!request.scene) return map;
    const LoopStop loops(stop);
    request.rootFinder = RootFinder::certified;
    const TracedView truth = traceView(request, threads, stop, report);
    if (!truth.complete) return map;
    map.width = truth.width;
    map.height = truth.height;
    map.shares.assign(truth.pixels.size(), unseen);
    const double tolerance = sheetTolerance(*request.scene);
    for (std::size_t k = 0; k < request.scene->isosurfaces.size() && !stop.stop_requested(); ++k) {
        const auto& shape = request.scene->isosurfaces[k].shape;
        if (!shape) continue;
        const double setting = shape->rootSettings().maxGradient;
        const std::vector<double> slopes = slopesOnSurface(request, truth, k, tolerance);
        for (std::size_t i = 0; i < slopes.size(); ++i)
            if (!std::isnan(slopes[i])) map.shares[i] = static_cast<float>(slopes[i] / setting);
    }
    for (const float share : map.shares) {
        if (std::isnan(share)) continue;
        ++map.seen;
        map.over += share > 1;
        map.largest = std::max(map.largest, static_cast<double>(share));
    }
    map.complete = !stop.stop_requested();
    return map;
}

}  // namespace isoscope
