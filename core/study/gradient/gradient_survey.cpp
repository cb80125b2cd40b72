// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/gradient_survey.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/evaluate/tape/loop_stop.h"
#include "core/study/accuracy/scene_variant.h"
#include "core/study/gradient/gradient_heat_map.h"
#include "core/study/gradient/gradient_verdict.h"

namespace isoscope {

namespace {

class Surveyor {
  public:
    Surveyor(const GradientSurveyRequest& request, const std::function<void(const GradientSurvey&)>& report,
             std::stop_token stop)
        : request_(request),
          report_(report),
          stop_(std::move(stop)),
          placed_(request.view.scene->isosurfaces[request.isosurface]),
          surface_(*placed_.shape) {
        survey_.setting = surface_.rootSettings().maxGradient;
        if (request.proof) survey_.bracket = request.proof->bracket();
    }

    void run() {
        const LoopStop loops(stop_);
        truth_ = trace(*request_.view.scene, RootFinder::certified);
        const TracedView tested = trace(*request_.view.scene, RootFinder::lipschitz);
        tolerance_ = sheetTolerance(*request_.view.scene);
        survey_.holes = compareViews(tested, truth_, tolerance_);
        survey_.alongRays = tested.steepestOf[request_.isosurface];
        lookAtSurface();
        if (!say()) return;
        survey_.histogram = gradientHistogram(*request_.view.scene, request_.isosurface, stop_);
        if (!say()) return;
        prove();
        if (!say()) return;
        survey_.enoughForView = enoughForView();
        survey_.finished = !stop_.stop_requested();
        say();
    }

  private:
    /// Reports; false when it is time to stop.
    bool say() {
        if (stop_.stop_requested()) return false;
        report_(survey_);
        return true;
    }

    TracedView trace(const Scene& scene, RootFinder finder) const {
        RenderRequest request = request_.view;
        request.scene = std::shared_ptr<const Scene>(request_.view.scene, &scene);
        request.rootFinder = finder;
        return traceView(request, request_.threads, stop_);
    }

    void lookAtSurface() {
        const std::vector<double> slopes =
            slopesOnSurface(request_.view, truth_, request_.isosurface, tolerance_);
        for (std::size_t i = 0; i < slopes.size(); ++i) {
            if (!(slopes[i] > survey_.onSurface) || std::isinf(slopes[i])) continue;
            survey_.onSurface = slopes[i];
            const auto width = static_cast<std::size_t>(truth_.width);
            const Ray ray = pixelRay(request_.view, static_cast<int>(i % width), static_cast<int>(i / width));
            survey_.steepestPoint = placed_.transform.inverse().point(ray.at(truth_.pixels[i].t));
        }
    }

    void prove() {
        constexpr std::uint64_t boxesBetweenReports = 20'000;
        const auto proof = request_.proof ? request_.proof
                                          : std::make_shared<GradientProof>(
                                                surface_.tape(), request_.view.scene->parameterTable,
                                                surface_.settings().container, request_.settings);
        bool more = true;
        while (more) {
            more = proof->advance(boxesBetweenReports, stop_);
            survey_.bracket = proof->bracket();
            if (more && !say()) return;
        }
    }

    std::uint64_t mistakes(double maxGradient) const {
        const auto variant =
            sceneVariant(*request_.view.scene, [&](const Isosurface& one, IsosurfaceSettings& settings) {
                if (&one == &surface_) settings.maxGradient = maxGradient;
            });
        return compareViews(trace(*variant, RootFinder::lipschitz), truth_, tolerance_).mistakes();
    }

    std::optional<double> enoughForView() const {
        const double seen = std::max(survey_.alongRays, survey_.onSurface);
        if (!(seen > 0)) return {};
        double high = suggestedGradient(survey_.bracket);
        if (!std::isfinite(high)) high = roundValueAbove(64 * seen);
        // Sheets thinner than the accuracy are lost with any setting.
        const std::uint64_t unavoidable = mistakes(high);
        double low = 0;
        for (int round = 0; round < 7 && !stop_.stop_requested(); ++round) {
            const double middle = roundValueAbove(low > 0 ? std::sqrt(low * high) : seen / 4);
            if (!(middle > low) || !(middle < high)) break;
            (mistakes(middle) <= unavoidable ? high : low) = middle;
        }
        return high;
    }

    const GradientSurveyRequest& request_;
    const std::function<void(const GradientSurvey&)>& report_;
    std::stop_token stop_;
    const SceneIsosurface& placed_;
    const Isosurface& surface_;
    TracedView truth_;
    double tolerance_ = 0;
    GradientSurvey survey_;
};

}  // namespace

void surveyGradient(const GradientSurveyRequest& request,
                    const std::function<void(const GradientSurvey&)>& report, std::stop_token stop) {
    if (!request.view.scene || request.isosurface >= request.view.scene->isosurfaces.size()) return;
    if (!request.view.scene->isosurfaces[request.isosurface].shape) return;
    Surveyor(request, report, std::move(stop)).run();
}

}  // namespace isoscope
