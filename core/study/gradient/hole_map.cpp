// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/hole_map.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace isoscope {

namespace {

HolePixel compare(const TracedPixel& tested, const TracedPixel& truth, double tolerance) {
    if (!tested.found) return truth.found ? HolePixel::lost : HolePixel::background;
    if (!truth.found) return HolePixel::gained;
    return std::abs(tested.t - truth.t) <= tolerance + 1e-9 * std::abs(truth.t) ? HolePixel::right
                                                                                : HolePixel::wrongPlace;
}

std::array<float, 3> colorOf(HolePixel pixel) {
    switch (pixel) {
        case HolePixel::background: return {0, 0, 0};
        case HolePixel::right: return {0.25f, 0.25f, 0.25f};
        case HolePixel::lost: return {0.85f, 0.05f, 0.03f};
        case HolePixel::gained: return {0.03f, 0.15f, 0.9f};
        case HolePixel::wrongPlace: return {0.9f, 0.7f, 0.02f};
    }
    return {};
}

}  // namespace

HoleMap compareViews(const TracedView& tested, const TracedView& truth, double tolerance) {
    HoleMap map;
    if (tested.width != truth.width || tested.height != truth.height) return map;
    map.width = tested.width;
    map.height = tested.height;
    map.complete = tested.complete && truth.complete;
    map.pixels.reserve(tested.pixels.size());
    for (std::size_t i = 0; i < tested.pixels.size(); ++i) {
        const HolePixel pixel = compare(tested.pixels[i], truth.pixels[i], tolerance);
        map.pixels.push_back(pixel);
        ++map.counts[static_cast<std::size_t>(pixel)];
    }
    return map;
}

double sheetTolerance(const Scene& scene) {
    double accuracy = 0;
    for (const SceneIsosurface& isosurface : scene.isosurfaces) {
        if (!isosurface.shape) continue;
        double stretch = 1;
        const Transform& transform = isosurface.transform;
        for (const glm::dvec3 axis : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)})
            stretch = std::max(stretch, glm::length(transform.direction(axis)));
        accuracy = std::max(accuracy, isosurface.shape->rootSettings().accuracy * stretch);
    }
    // Both root finders may be off by the accuracy, and the slanting ray adds to it.
    return 4 * accuracy;
}

HoleMap holeMap(RenderRequest request, int threads, std::stop_token stop, const ShareReport& report) {
    if (!request.scene) return {};
    const auto half = [&](double from) {
        return [&report, from](double share) {
            if (report) report(from + share / 2);
        };
    };
    request.rootFinder = RootFinder::lipschitz;
    const TracedView tested = traceView(request, threads, stop, half(0));
    request.rootFinder = RootFinder::certified;
    const TracedView truth = traceView(request, threads, stop, half(0.5));
    return compareViews(tested, truth, sheetTolerance(*request.scene));
}

Image picture(const HoleMap& map) {
    Image image(map.width, map.height);
    for (std::size_t i = 0; i < map.pixels.size(); ++i) image.pixels[i] = colorOf(map.pixels[i]);
    return image;
}

}  // namespace isoscope
