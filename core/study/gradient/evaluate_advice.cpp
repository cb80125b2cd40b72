// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/evaluate_advice.h"

#include <algorithm>
#include <cmath>

#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/study/accuracy/scene_variant.h"
#include "core/study/gradient/gradient_domain.h"
#include "core/study/gradient/gradient_study.h"
#include "core/study/gradient/hole_map.h"
#include "core/study/gradient/spread_points.h"

namespace isoscope {

namespace {

constexpr int width = 80;
constexpr std::size_t pointCount = 16'384;
constexpr std::uint64_t boxLimit = 100'000;
constexpr double bracketWidth = 0.02;
constexpr double quantiles[] = {0.5, 0.9, 0.99, 0.999};
constexpr double factors[] = {1.2, 2};            ///< P1
constexpr double attenuations[] = {0.7, 0.9, 1};  ///< P2

/// Lengths of the gradient at points of the container, in ascending order; fewer after a stop.
std::vector<double> gradientsIn(const Isosurface& surface, std::span<const double> parameters,
                                const std::stop_token& stop) {
    const GradientDomain domain(surface.settings().container);
    if (domain.empty()) return {};
    const SpreadPoints points = spreadPoints(domain, pointCount);
    std::vector<ValueAndGradient> all(points.x.size());
    GradientEvaluator evaluator(surface.prepared(parameters));
    constexpr std::size_t slice = 256;  // between two looks at the stop
    for (std::size_t first = 0; first < all.size() && !stop.stop_requested(); first += slice) {
        const std::size_t count = std::min(slice, all.size() - first);
        evaluator.evaluate(std::span(points.x).subspan(first, count),
                           std::span(points.y).subspan(first, count),
                           std::span(points.z).subspan(first, count), std::span(all).subspan(first, count));
    }
    std::vector<double> lengths;
    for (const ValueAndGradient& one : all) {
        const double length = slopeOf(one);
        if (length > 0 && std::isfinite(length)) lengths.push_back(length);
    }
    std::ranges::sort(lengths);
    return lengths;
}

/// What P0 is to be tried with: two digits each, none twice.
std::vector<double> startsFrom(const std::vector<double>& gradients, double steepestMet) {
    std::vector<double> starts;
    for (const double share : quantiles)
        starts.push_back(
            gradients[static_cast<std::size_t>(share * static_cast<double>(gradients.size() - 1))]);
    if (steepestMet > 0 && std::isfinite(steepestMet)) starts.push_back(steepestMet);
    for (double& start : starts) start = roundValueAbove(start);
    std::ranges::sort(starts);
    starts.erase(std::unique(starts.begin(), starts.end()), starts.end());
    return starts;
}

}  // namespace

const BoundTrial* EvaluateAdvice::best() const {
    const BoundTrial* best = nullptr;
    for (const BoundTrial& trial : trials) {
        const bool right = fixed.maxGradient > 0 ? trial.mistakes <= fixed.mistakes : trial.mistakes == 0;
        const bool cheaper =
            !(fixed.maxGradient > 0) || trial.evaluationsPerPixel < fixed.evaluationsPerPixel;
        if (right && cheaper && (!best || trial.evaluationsPerPixel < best->evaluationsPerPixel))
            best = &trial;
    }
    return best;
}

EvaluateAdvice adviseEvaluate(RenderRequest view, std::size_t isosurface, int threads, std::stop_token stop,
                              const ShareReport& report) {
    EvaluateAdvice advice;
    if (!view.scene || isosurface >= view.scene->isosurfaces.size() || view.width < 1) return advice;
    const std::shared_ptr<const Scene> scene = view.scene;
    const Isosurface* subject = scene->isosurfaces[isosurface].shape.get();
    if (!subject) return advice;
    view.height = std::max(1, view.height * width / view.width);
    view.width = width;
    advice.pixels = static_cast<std::uint64_t>(view.width) * static_cast<std::uint64_t>(view.height);
    const LoopStop loops(stop);
    const std::vector<double> gradients = gradientsIn(*subject, *scene->parameterTable, stop);
    GradientStudy study(subject->prepared(*scene->parameterTable), subject->settings().container,
                        {bracketWidth, boxLimit});
    const double proven = roundValueAbove(study.run(stop).upper);
    if (gradients.empty() || stop.stop_requested()) return advice;
    view.rootFinder = RootFinder::certified;
    const TracedView truth = traceView(view, threads, stop);
    view.rootFinder = RootFinder::lipschitz;
    const double tolerance = sheetTolerance(*scene);
    double steepestMet = 0;
    const auto measure = [&](BoundTrial& trial) {
        view.scene = sceneVariant(*scene, [&](const Isosurface& original, IsosurfaceSettings& settings) {
            if (&original != subject) return;
            settings.evaluate = trial.evaluate;
            if (trial.maxGradient > 0) settings.maxGradient = trial.maxGradient;
        });
        const TracedView traced = traceView(view, threads, stop);
        trial.evaluationsPerPixel =
            static_cast<double>(traced.evaluations) / static_cast<double>(advice.pixels);
        steepestMet = std::max(steepestMet, traced.steepest);
        trial.mistakes = compareViews(traced, truth, tolerance).mistakes();
    };
    if (proven > 0) {
        BoundTrial fixed;
        fixed.maxGradient = proven;
        measure(fixed);
        if (stop.stop_requested()) return advice;
        advice.fixed = fixed;
    }
    const std::vector<double> starts = startsFrom(gradients, steepestMet);
    const double count = static_cast<double>(starts.size() * std::size(factors) * std::size(attenuations));
    for (const double start : starts)
        for (const double factor : factors)
            for (const double attenuation : attenuations) {
                BoundTrial trial;
                trial.evaluate = {start, factor, attenuation};
                trial.maxGradient = start;
                measure(trial);
                if (stop.stop_requested()) return advice;
                advice.trials.push_back(trial);
                if (report) report(static_cast<double>(advice.trials.size()) / count);
            }
    advice.complete = true;
    return advice;
}

}  // namespace isoscope
