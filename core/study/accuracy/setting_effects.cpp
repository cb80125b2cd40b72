// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/accuracy/setting_effects.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/evaluate/tape/loop_stop.h"
#include "core/study/accuracy/scene_variant.h"
#include "core/study/gradient/gradient_heat_map.h"
#include "core/study/gradient/hole_map.h"

namespace isoscope {

namespace {

/// The hits of `view` in the pixels where `map` has one of `kinds`; nothing elsewhere.
TracedView onlyWhere(const TracedView& view, const HoleMap& map, std::initializer_list<HolePixel> kinds) {
    TracedView some = view;
    for (std::size_t i = 0; i < some.pixels.size(); ++i)
        if (std::ranges::find(kinds, map.pixels[i]) == kinds.end()) some.pixels[i].found = false;
    return some;
}

/// The pixel with the least distance to the middle of all.
std::size_t middleOf(const std::vector<std::size_t>& pixels, std::size_t width) {
    const auto at = [width](std::size_t pixel) {
        return glm::dvec2(static_cast<double>(pixel % width), static_cast<double>(pixel / width));
    };
    glm::dvec2 middle(0);
    for (const std::size_t pixel : pixels) middle += at(pixel) / static_cast<double>(pixels.size());
    return *std::ranges::min_element(pixels, {},
                                     [&](std::size_t pixel) { return glm::distance(at(pixel), middle); });
}

void countMistakes(const RenderRequest& request, const TracedView& wrong, const TracedView& missing,
                   std::size_t isosurface, double tolerance, SurfaceEffects& effects) {
    std::vector<std::size_t> pixels;
    for (const TracedView* view : {&missing, &wrong}) {
        const std::vector<double> slopes = slopesOnSurface(request, *view, isosurface, tolerance);
        for (std::size_t i = 0; i < slopes.size(); ++i)
            if (!std::isnan(slopes[i])) pixels.push_back(i);
    }
    std::ranges::sort(pixels);
    pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
    effects.mistakes = pixels.size();
    if (pixels.empty()) return;
    const std::size_t middle = middleOf(pixels, static_cast<std::size_t>(request.width));
    const TracedView& there = missing.pixels[middle].found ? missing : wrong;
    const auto width = static_cast<std::size_t>(request.width);
    effects.place = pixelRay(request, static_cast<int>(middle % width), static_cast<int>(middle / width))
                        .at(there.pixels[middle].t);
}

}  // namespace

SettingEffects settingEffects(RenderRequest view, int threads, std::stop_token stop) {
    SettingEffects effects;
    if (!view.scene) return effects;
    const LoopStop loops(stop);
    view.rootFinder = RootFinder::lipschitz;
    const TracedView tested = traceView(view, threads, stop);
    view.rootFinder = RootFinder::certified;
    const TracedView truth = traceView(view, threads, stop);
    if (!tested.complete || !truth.complete) return effects;
    const double tolerance = sheetTolerance(*view.scene);
    const HoleMap map = compareViews(tested, truth, tolerance);
    const TracedView missing = onlyWhere(truth, map, {HolePixel::lost, HolePixel::wrongPlace});
    const TracedView wrong = onlyWhere(tested, map, {HolePixel::gained});
    effects.surfaces.resize(view.scene->isosurfaces.size());
    for (std::size_t i = 0; i < effects.surfaces.size() && !stop.stop_requested(); ++i) {
        effects.surfaces[i].alongRays = tested.steepestOf[i];
        if (map.mistakes() > 0) countMistakes(view, wrong, missing, i, tolerance, effects.surfaces[i]);
    }
    effects.pixels = map.pixels.size();
    effects.evaluations = tested.evaluations;
    effects.complete = !stop.stop_requested();
    return effects;
}

std::optional<double> costBeside(RenderRequest view, std::size_t isosurface, double maxGradient,
                                 std::uint64_t evaluations, int threads, std::stop_token stop) {
    if (!view.scene || isosurface >= view.scene->isosurfaces.size()) return {};
    const Isosurface* surface = view.scene->isosurfaces[isosurface].shape.get();
    view.scene = sceneVariant(*view.scene, [&](const Isosurface& one, IsosurfaceSettings& settings) {
        if (&one == surface) settings.maxGradient = maxGradient;
    });
    view.rootFinder = RootFinder::lipschitz;
    const TracedView other = traceView(view, threads, stop);
    if (!other.complete || other.evaluations == 0) return {};
    return static_cast<double>(evaluations) / static_cast<double>(other.evaluations);
}

}  // namespace isoscope
