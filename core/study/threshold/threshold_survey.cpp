// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/threshold/threshold_survey.h"

#include <algorithm>
#include <cmath>

#include "core/evaluate/point_evaluator.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/study/gradient/spread_points.h"

namespace isoscope {

namespace {

constexpr std::size_t pointCount = 16'384;
constexpr std::size_t pointsAtOnce = 1'024;
constexpr int binCount = 60;
/// Of the samples, at each end.
constexpr double cutShare = 0.005;
/// Values closer than this, relative to their size, are one tick.
constexpr double sameValue = 1e-7;

std::vector<double> valuesIn(const Isosurface& surface, std::span<const double> parameters,
                             const std::stop_token& stop) {
    const GradientDomain domain(surface.settings().container);
    if (domain.empty()) return {};
    const SpreadPoints points = spreadPoints(domain, pointCount);
    std::vector<double> values(points.x.size());
    PointEvaluator evaluator(surface.prepared(parameters));
    for (std::size_t first = 0; first < values.size() && !stop.stop_requested(); first += pointsAtOnce) {
        const std::size_t count = std::min(pointsAtOnce, values.size() - first);
        evaluator.evaluate(
            std::span(points.x).subspan(first, count), std::span(points.y).subspan(first, count),
            std::span(points.z).subspan(first, count), std::span(values).subspan(first, count));
    }
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    std::sort(values.begin(), values.end());
    return values;
}

}  // namespace

ValueHistogram valueHistogram(const Isosurface& surface, std::span<const double> parameters,
                              std::stop_token stop) {
    const LoopStop loops(stop);
    ValueHistogram histogram;
    const std::vector<double> values = valuesIn(surface, parameters, stop);
    if (values.empty() || stop.stop_requested()) return histogram;
    const auto cut = static_cast<std::size_t>(cutShare * static_cast<double>(values.size()));
    double low = values.front(), high = values.back();
    const double inner = values[values.size() - 1 - cut] - values[cut];
    if (high - low > 1.5 * inner && inner > 0) low = values[cut], high = values[values.size() - 1 - cut];
    if (!(high > low)) {
        const double margin = std::max(1e-6, 1e-6 * std::abs(low));
        low -= margin, high += margin;
    }
    for (int k = 0; k <= binCount; ++k) {
        const double share = static_cast<double>(k) / binCount;
        histogram.edges.push_back(low * (1 - share) + high * share);
    }
    histogram.shares.assign(binCount, 0);
    for (const double value : values) {
        if (value < low || value > high) continue;
        const auto bin = static_cast<int>((value / binCount - low / binCount) /
                                          (high / binCount - low / binCount) * binCount);
        histogram.shares[static_cast<std::size_t>(std::clamp(bin, 0, binCount - 1))] +=
            1 / static_cast<double>(values.size());
    }
    return histogram;
}

void surveyThresholds(const Scene& scene, std::size_t isosurface, const CriticalStudySettings& settings,
                      const std::function<void(const ThresholdSurvey&)>& report, std::stop_token stop) {
    if (isosurface >= scene.isosurfaces.size() || !scene.isosurfaces[isosurface].shape) return;
    const Isosurface& surface = *scene.isosurfaces[isosurface].shape;
    ThresholdSurvey survey;
    survey.histogram = valueHistogram(surface, *scene.parameterTable, stop);
    if (stop.stop_requested()) return;
    report(survey);
    CriticalStudy study(surface.prepared(*scene.parameterTable), surface.settings().container, settings);
    survey.critical = study.run(
        [&](double done) {
            if (done < survey.progress + 0.01) return;
            survey.progress = done;
            report(survey);
        },
        stop);
    if (stop.stop_requested()) return;
    survey.progress = 1;
    survey.complete = true;
    report(survey);
}

std::vector<ThresholdTick> thresholdTicks(const CriticalPoints& critical) {
    std::vector<ThresholdTick> ticks;
    for (const CriticalPoint& point : critical.points) {
        if (!std::isfinite(point.value)) continue;
        if (ticks.empty() ||
            point.value - ticks.back().value > sameValue * std::max(1e-3, std::abs(ticks.back().value)))
            ticks.push_back({point.value, {}});
        ThresholdTick& tick = ticks.back();
        if (point.proven() && !tick.points.empty() && !tick.proven()) tick.value = point.value;
        const auto place = std::find_if(tick.points.begin(), tick.points.end(),
                                        [](const CriticalPoint& other) { return !other.proven(); });
        tick.points.insert(point.proven() ? place : tick.points.end(), point);
    }
    return ticks;
}

}  // namespace isoscope
