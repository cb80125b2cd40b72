// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/accuracy/cost_survey.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/evaluate/tape/loop_stop.h"
#include "core/study/accuracy/scene_variant.h"
#include "core/study/gradient/hole_map.h"

namespace isoscope {

namespace {

constexpr int probeWidth = 24;
constexpr int narrowest = 40, widest = 128;
constexpr int tile = 8;
constexpr int povrayWidth = 64;
/// Operations of functions for all values together: about two seconds of one core.
constexpr double affordableSteps = 4e9;
/// What evaluating an enclosure takes beside a value.
constexpr double enclosureSteps = 4;
/// One pixel in so many may differ; see CostSurvey::knee.
constexpr std::size_t sameUpTo = 200;

int heightFor(int width, const RenderRequest& view) {
    return std::max(
        1, static_cast<int>(std::lround(static_cast<double>(width) * view.height / std::max(1, view.width))));
}

double sizeOf(const Container& container) {
    if (const auto* sphere = std::get_if<ContainerSphere>(&container)) return 2 * std::abs(sphere->radius);
    const auto& box = std::get<ContainerBox>(container);
    return std::max({std::abs(box.high.x - box.low.x), std::abs(box.high.y - box.low.y),
                     std::abs(box.high.z - box.low.z)});
}

double stepsOf(const Scene& scene) {
    double steps = 1;
    for (const SceneIsosurface& isosurface : scene.isosurfaces) {
        if (!isosurface.shape) continue;
        const FunctionWork work = workOf(*isosurface.shape->tape(), *scene.parameterTable);
        steps =
            std::max(steps, work.products + work.sums + 2 * work.quotients + 4 * (work.waves + work.powers) +
                                20 * (work.noises + work.vectorNoises) + 200 * work.cells);
    }
    return steps;
}

}  // namespace

SurveyedRange surveyedRange(StudiedSetting setting) {
    return setting == StudiedSetting::accuracy ? SurveyedRange{1e-6, 1} : SurveyedRange{0.1, 1000};
}

std::vector<double> surveyValues(double low, double high) {
    if (!(low > 0) || !(high > low) || !std::isfinite(high)) return {};
    std::vector<double> values;
    const auto fill = [&](std::initializer_list<double> digits) {
        values = {low};
        for (int decade = static_cast<int>(std::floor(std::log10(low)));
             decade <= std::ceil(std::log10(high)); ++decade)
            for (const double digit : digits) {
                const double value =
                    decade < 0 ? digit / std::pow(10.0, -decade) : digit * std::pow(10.0, decade);
                // Not what lies beside an end: it would tell the same.
                if (value > low * 1.2 && value < high / 1.2) values.push_back(value);
            }
        values.push_back(high);
    };
    fill({1});
    if (values.size() < 5) fill({1, 2, 5});
    std::vector<double> ordered{values.front(), values.back()};
    std::vector<std::size_t> gaps{0, values.size() - 1};
    while (gaps.size() < values.size()) {
        std::vector<std::size_t> finer{gaps.front()};
        for (std::size_t i = 1; i < gaps.size(); ++i) {
            const std::size_t middle = (gaps[i - 1] + gaps[i]) / 2;
            if (middle != gaps[i - 1]) {
                ordered.push_back(values[middle]);
                finer.push_back(middle);
            }
            finer.push_back(gaps[i]);
        }
        gaps = std::move(finer);
    }
    return ordered;
}

CostSurvey::CostSurvey(CostSurveyRequest request) : request_(std::move(request)) {}

RenderRequest CostSurvey::with(double value, RootFinder finder) const {
    RenderRequest changed = small_;
    changed.rootFinder = finder;
    const Isosurface* varied = request_.view.scene->isosurfaces[request_.isosurface].shape.get();
    changed.scene =
        sceneVariant(*request_.view.scene, [&](const Isosurface& original, IsosurfaceSettings& settings) {
            if (&original != varied) return;
            (request_.setting == StudiedSetting::accuracy ? settings.accuracy : settings.maxGradient) = value;
        });
    return changed;
}

bool CostSurvey::prepare(std::stop_token stop) {
    if (truth_.complete && povray_.complete) return true;
    const RenderRequest& view = request_.view;
    if (!view.scene || request_.values.empty() || view.width < 1 || view.height < 1) return false;
    if (request_.isosurface >= view.scene->isosurfaces.size()) return false;
    if (!view.scene->isosurfaces[request_.isosurface].shape) return false;
    small_ = view;
    small_.antialias = false;
    small_.verdicts = nullptr;
    small_.width = probeWidth;
    small_.height = heightFor(probeWidth, view);
    // The ends stand for all values.
    const auto [low, high] = std::minmax_element(request_.values.begin(), request_.values.end());
    double evaluations = 0;
    for (const double value : {*low, *high})
        for (const RootFinder finder : {RootFinder::lipschitz, RootFinder::certified})
            evaluations +=
                static_cast<double>(traceView(with(value, finder), 1, stop, {}, tile).evaluations) *
                (finder == RootFinder::certified ? enclosureSteps : 1);
    if (stop.stop_requested()) return false;
    const double perPixel =
        std::max(1.0, evaluations / 2 * stepsOf(*view.scene) * static_cast<double>(request_.values.size()) /
                          (small_.width * small_.height));
    const double proportion = static_cast<double>(view.width) / view.height;
    small_.width = static_cast<int>(
        std::clamp(std::sqrt(affordableSteps / perPixel * proportion), double{narrowest}, double{widest}));
    small_.height = heightFor(small_.width, view);

    povray_ = countForPovray(view, std::min(povrayWidth, small_.width), stop);
    RenderRequest exact = small_;
    exact.rootFinder = RootFinder::certified;
    exact.scene = sceneVariant(*view.scene, [](const Isosurface&, IsosurfaceSettings& settings) {
        settings.accuracy = 1e-13 * sizeOf(settings.container);
    });
    truth_ = traceView(exact, 1, stop, {}, tile);
    tolerance_ = sheetTolerance(*view.scene);
    return truth_.complete && povray_.complete;
}

std::optional<CostPoint> CostSurvey::next(std::stop_token stop) {
    if (points_.size() >= request_.values.size()) return {};
    const LoopStop loops(stop);
    if (!prepare(stop)) return {};
    CostPoint point;
    point.setting = request_.values[points_.size()];
    TracedView povray;
    for (const RootFinder finder : {RootFinder::lipschitz, RootFinder::certified}) {
        TracedView view = traceView(with(point.setting, finder), 1, stop, {}, tile);
        if (!view.complete) return {};
        const auto index = static_cast<std::size_t>(finder);
        const double accuracy = request_.setting == StudiedSetting::accuracy ? point.setting : 0;
        point.evaluationsPerPixel[index] =
            static_cast<double>(view.evaluations) / static_cast<double>(view.pixels.size());
        point.cpuSecondsPerPixel[index] = view.cpuSeconds / static_cast<double>(view.pixels.size());
        point.lost[index] =
            compareViews(view, truth_, std::max(tolerance_, 4 * accuracy)).count(HolePixel::lost);
        if (finder == RootFinder::lipschitz) povray = std::move(view);
    }
    points_.push_back(point);
    views_.push_back(std::move(povray));
    return point;
}

double CostSurvey::pixelWidth(const TracedPixel& pixel, std::size_t index) const {
    const int x = static_cast<int>(index) % small_.width, y = static_cast<int>(index) / small_.width;
    const Ray ray = pixelRay(small_, x, y);
    const double step = 1.0 / std::max(1, request_.view.width);
    const Ray next =
        small_.camera.ray((x + 0.5) / small_.width - 0.5 + step, 0.5 - (y + 0.5) / small_.height);
    return glm::length(ray.origin + pixel.t * ray.direction - next.origin - pixel.t * next.direction);
}

std::optional<double> CostSurvey::knee() const {
    if (!complete() || points_.size() < 2) return {};
    std::vector<std::size_t> order(points_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const bool downwards = request_.setting == StudiedSetting::accuracy;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return downwards ? points_[a].setting < points_[b].setting : points_[a].setting > points_[b].setting;
    });
    const TracedView& dearest = views_[order.front()];
    std::size_t hits = 0;
    for (const TracedPixel& pixel : dearest.pixels) hits += pixel.found;
    std::size_t knee = 0;
    for (std::size_t k = 1; k < order.size(); ++k) {
        const TracedView& view = views_[order[k]];
        std::size_t different = 0;
        for (std::size_t i = 0; i < view.pixels.size(); ++i) {
            const TracedPixel &a = view.pixels[i], &b = dearest.pixels[i];
            different += a.found != b.found || (a.found && std::abs(a.t - b.t) > pixelWidth(b, i));
        }
        if (different * sameUpTo > hits) break;
        knee = k;
    }
    if (knee == 0 || hits == 0) return {};
    return points_[order[knee]].setting;
}

double certifiedSeconds(const CostPoint& point, const std::vector<CostPoint>& all, const PovrayCounts& povray,
                        double pixels) {
    constexpr auto certified = static_cast<std::size_t>(RootFinder::certified);
    double seconds = 0, evaluations = 0;
    for (const CostPoint& other : all) {
        seconds += other.cpuSecondsPerPixel[certified];
        evaluations += other.evaluationsPerPixel[certified];
    }
    if (evaluations <= 0) return 0;
    return pixels * point.evaluationsPerPixel[certified] * seconds / evaluations * povray.lightFactor();
}

}  // namespace isoscope
