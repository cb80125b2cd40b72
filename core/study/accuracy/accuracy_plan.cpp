// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/accuracy/accuracy_plan.h"

#include <algorithm>
#include <cmath>

#include "core/evaluate/tape/loop_stop.h"
#include "core/study/gradient/gradient_study.h"

namespace isoscope {

namespace {

constexpr int probeWidth = 24;
constexpr int narrowest = 32, widest = 400;
/// Enough for a sensible end of the range; the Gradient panel proves more tightly.
constexpr std::uint64_t boundBoxes = 20'000;
constexpr int runsPerValue = 3;

int heightFor(int width, const RenderRequest& view) {
    return std::max(
        1, static_cast<int>(std::lround(static_cast<double>(width) * view.height / std::max(1, view.width))));
}

double boundOf(const Scene& scene, const Isosurface& surface, const std::stop_token& stop) {
    GradientStudySettings settings;
    settings.boxLimit = boundBoxes;
    GradientStudy study(surface.tape(), *scene.parameterTable, surface.settings().container, settings);
    const double upper = study.run(stop).upper;
    return upper > 0 && std::isfinite(upper) ? upper : surface.rootSettings().maxGradient;
}

}  // namespace

SettingRange studiedRange(const Scene& scene, StudiedSetting setting, std::stop_token stop) {
    if (setting == StudiedSetting::accuracy) return {1e-1, 1e-9};
    double largest = 0;
    for (const SceneIsosurface& isosurface : scene.isosurfaces)
        if (isosurface.shape && !stop.stop_requested())
            largest = std::max(largest, boundOf(scene, *isosurface.shape, stop));
    return largest > 0 ? SettingRange{largest / 10, largest * 10} : SettingRange{0.1, 10};
}

AccuracyStudyRequest planAccuracyStudy(RenderRequest view, StudiedSetting setting, int count,
                                       double cpuSeconds, std::stop_token stop) {
    AccuracyStudyRequest request;
    request.view = std::move(view);
    request.setting = setting;
    request.runs = runsPerValue;
    request.threads = 1;
    if (!request.view.scene) return request;
    const LoopStop loops(stop);
    const RenderRequest whole = request.view;
    const SettingRange range = studiedRange(*whole.scene, setting, stop);

    request.view.width = probeWidth;
    request.view.height = heightFor(probeWidth, whole);
    request.values = {range.from, range.to};
    AccuracyStudyRequest probe = request;
    probe.runs = 1;
    AccuracyStudy study(std::move(probe));
    double sum = 0;
    while (const auto point = study.next(stop)) sum += point->cpuSeconds;
    const double pixels = static_cast<double>(request.view.width) * request.view.height;
    // The ends stand for all values; the truth and the present pictures are about one more run each.
    const double perPixel = std::max(1e-9, (sum * count / 2 * runsPerValue + 2 * sum) / pixels);
    const double affordable = cpuSeconds / perPixel;
    const double proportion = static_cast<double>(whole.width) / std::max(1, whole.height);
    const int width = std::clamp(static_cast<int>(std::sqrt(affordable * proportion)), narrowest, widest);
    request.view.width = std::min(width, std::max(1, whole.width));
    request.view.height = heightFor(request.view.width, whole);
    request.values = stop.stop_requested() ? std::vector<double>() : studyValues(range.from, range.to, count);
    return request;
}

}  // namespace isoscope
