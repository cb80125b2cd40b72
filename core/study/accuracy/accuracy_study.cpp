// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/accuracy/accuracy_study.h"

#include <algorithm>
#include <cmath>

#include "core/study/accuracy/scene_variant.h"

namespace isoscope {

namespace {

/// The truth, and the present picture of both root finders.
constexpr std::size_t preparations = 3;
constexpr int smallPicture = 128;
constexpr int smallTile = 8;

double sizeOf(const Container& container) {
    if (const auto* sphere = std::get_if<ContainerSphere>(&container)) return 2 * std::abs(sphere->radius);
    const auto& box = std::get<ContainerBox>(container);
    return std::max({std::abs(box.high.x - box.low.x), std::abs(box.high.y - box.low.y),
                     std::abs(box.high.z - box.low.z)});
}

bool differs(const TracedPixel& a, const TracedPixel& b, double tolerance) {
    return a.found != b.found || (a.found && std::abs(a.t - b.t) > tolerance);
}

}  // namespace

std::vector<double> studyValues(double from, double to, int count) {
    if (!(from > 0) || !(to > 0) || !std::isfinite(from) || !std::isfinite(to) || count < 1) return {};
    if (count == 1) return {from};
    const auto value = [&](int k) {
        if (k == 0) return from;
        if (k == count - 1) return to;
        return from * std::pow(to / from, static_cast<double>(k) / (count - 1));
    };
    std::vector<bool> taken(static_cast<std::size_t>(count), false);
    std::vector<double> values;
    for (int step = count - 1; step >= 1; step = step > 1 ? (step + 1) / 2 : 0)
        for (int k = 0; k < count; k += step) {
            if (taken[static_cast<std::size_t>(k)]) continue;
            taken[static_cast<std::size_t>(k)] = true;
            values.push_back(value(k));
        }
    if (!taken.back()) values.push_back(to);
    return values;
}

AccuracyStudy::AccuracyStudy(AccuracyStudyRequest request) : request_(std::move(request)) {}

std::size_t AccuracyStudy::pictures() const {
    return preparations + size() * static_cast<std::size_t>(std::max(1, request_.runs));
}

TracedView AccuracyStudy::trace(const RenderRequest& request, std::size_t picture, std::stop_token stop,
                                const ShareReport& report) const {
    const auto all = static_cast<double>(pictures());
    const ShareReport whole = [&](double share) {
        if (report) report((static_cast<double>(picture) + share) / all);
    };
    // A small picture of a slow scene is as long in the making as a large one of a fast scene.
    const int tile = request.width < smallPicture ? smallTile : rendererTile;
    return traceView(request, request_.threads, stop, whole, tile);
}

bool AccuracyStudy::prepare(std::stop_token stop, const ShareReport& report) {
    if (truth_.complete) return true;
    if (!request_.view.scene) return false;
    RenderRequest exact = request_.view;
    exact.rootFinder = RootFinder::certified;
    exact.scene = sceneVariant(*request_.view.scene, [](const Isosurface&, IsosurfaceSettings& settings) {
        settings.accuracy = truthAccuracy * sizeOf(settings.container);
    });
    truth_ = trace(exact, 0, stop, report);
    for (const RootFinder finder : {RootFinder::lipschitz, RootFinder::certified}) {
        RenderRequest present = request_.view;
        present.rootFinder = finder;
        const auto index = static_cast<std::size_t>(finder);
        present_[index] = trace(present, 1 + index, stop, report);
    }
    tolerance_ = sheetTolerance(*request_.view.scene);
    return truth_.complete && present_[0].complete && present_[1].complete;
}

RenderRequest AccuracyStudy::with(double value, RootFinder finder) const {
    RenderRequest changed = request_.view;
    changed.rootFinder = finder;
    const StudiedSetting setting = request_.setting;
    changed.scene = sceneVariant(*request_.view.scene, [=](const Isosurface&, IsosurfaceSettings& settings) {
        (setting == StudiedSetting::accuracy ? settings.accuracy : settings.maxGradient) = value;
    });
    return changed;
}

std::optional<AccuracyPoint> AccuracyStudy::next(std::stop_token stop, const ShareReport& report) {
    if (done_ >= size() || !prepare(stop, report)) return {};
    AccuracyPoint point;
    point.setting = request_.values[done_ / 2];
    point.finder = done_ % 2 == 0 ? RootFinder::lipschitz : RootFinder::certified;
    const RenderRequest changed = with(point.setting, point.finder);
    std::vector<double> seconds;
    TracedView view;
    const auto runs = static_cast<std::size_t>(std::max(1, request_.runs));
    for (std::size_t run = 0; run < runs; ++run) {
        view = trace(changed, preparations + done_ * runs + run, stop, report);
        if (!view.complete) return {};
        seconds.push_back(view.cpuSeconds);
    }
    std::nth_element(seconds.begin(), seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2),
                     seconds.end());
    point.cpuSeconds = seconds[seconds.size() / 2];
    point.evaluations = view.evaluations;
    point.evaluationsPerPixel =
        static_cast<double>(view.evaluations) / static_cast<double>(view.pixels.size());
    judge(view, point);
    ++done_;
    return point;
}

void AccuracyStudy::judge(const TracedView& view, AccuracyPoint& point) const {
    const double accuracy = request_.setting == StudiedSetting::accuracy ? point.setting : 0;
    const double tolerance = std::max(tolerance_, 4 * accuracy);
    const HoleMap map = compareViews(view, truth_, tolerance);
    point.lost = map.count(HolePixel::lost);
    point.gained = map.count(HolePixel::gained);
    point.wrongPlace = map.count(HolePixel::wrongPlace);
    double sum = 0;
    std::uint64_t compared = 0;
    const TracedView& present = present_[static_cast<std::size_t>(point.finder)];
    for (std::size_t i = 0; i < view.pixels.size(); ++i) {
        point.changed += differs(view.pixels[i], present.pixels[i], tolerance);
        if (map.pixels[i] != HolePixel::right) continue;
        const double error = std::abs(view.pixels[i].t - truth_.pixels[i].t);
        point.worstError = std::max(point.worstError, error);
        sum += error;
        ++compared;
    }
    point.meanError = compared > 0 ? sum / static_cast<double>(compared) : 0;
}

}  // namespace isoscope
