// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/cost_surveyor.h"

#include <algorithm>

#include "core/study/accuracy/scene_likeness.h"
#include "widgets/background_priority.h"
#include "widgets/either_stop.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/studies/cost_strip.h"
#include "widgets/viewport/viewport.h"

namespace isoscope {

namespace {

/// Some views, of two settings each.
constexpr std::size_t keptPlots = 32;

CostPlot plotOf(const CostSurvey& survey, const CostSurveyRequest& request) {
    CostPlot plot;
    plot.setting = request.setting;
    plot.picture = {request.view.width, request.view.height};
    plot.counted = static_cast<quint64>(survey.width()) * static_cast<quint64>(survey.height());
    const double pixels = static_cast<double>(request.view.width) * request.view.height;
    for (const CostPoint& point : survey.points()) {
        CostPlot::Mark mark;
        mark.setting = point.setting;
        mark.seconds[0] = povraySeconds(survey.povray(), pixels, point.evaluationsPerPixel[0]);
        mark.seconds[1] = certifiedSeconds(point, survey.points(), survey.povray(), pixels);
        mark.lost = {point.lost[0], point.lost[1]};
        plot.marks.push_back(mark);
    }
    std::sort(plot.marks.begin(), plot.marks.end(),
              [](const auto& a, const auto& b) { return a.setting < b.setting; });
    const RootSettings& settings = request.view.scene->isosurfaces[request.isosurface].shape->rootSettings();
    plot.present = request.setting == StudiedSetting::accuracy ? settings.accuracy : settings.maxGradient;
    plot.presentSeconds = povraySeconds(survey.povray(), pixels);
    plot.knee = survey.knee();
    plot.complete = survey.complete();
    return plot;
}

}  // namespace

CostSurveyor::CostSurveyor(ParameterPanel* panel, QObject* parent) : QObject(parent), panel_(panel) {}

CostSurveyor::~CostSurveyor() { stop_.request_stop(); }

void CostSurveyor::setScene(std::shared_ptr<const Scene> scene) {
    if (scene == scene_) return;
    stop();
    scene_ = std::move(scene);
    if (!scene_) known_.clear();
    judgeStrips();
}

void CostSurveyor::setView(const Camera& camera) {
    if (camera == camera_) return;
    stop();
    camera_ = camera;
    judgeStrips();
}

void CostSurveyor::setPictureSize(QSize size) {
    if (size.isEmpty() || size == picture_) return;
    stop();
    picture_ = size;
    judgeStrips();
}

void CostSurveyor::rest() {
    resting_ = true;
    if (surveying_) return;
    judgeStrips();
    next();
}

void CostSurveyor::stop() {
    resting_ = surveying_ = false;
    stop_.request_stop();
    ++generation_;
}

std::optional<CostSurveyor::Subject> CostSurveyor::subjectOf(const ParameterSlider& slider) const {
    const SceneParameter& parameter = slider.parameter();
    if (!scene_ || !slider.strip()) return {};
    for (std::size_t i = 0; i < scene_->isosurfaces.size(); ++i) {
        const SourceRange& range = scene_->isosurfaces[i].range;
        const bool inside = range.file == parameter.range.file && range.begin <= parameter.range.begin &&
                            parameter.range.end <= range.end;
        if (!inside || !scene_->isosurfaces[i].shape) continue;
        return Subject{scene_,
                       fittedCamera(camera_, picture_.width(), picture_.height()),
                       picture_,
                       i,
                       parameter.role == ParameterRole::accuracy ? StudiedSetting::accuracy
                                                                 : StudiedSetting::maxGradient,
                       slider.minimum(),
                       slider.maximum()};
    }
    return {};
}

bool CostSurveyor::same(const Subject& a, const Subject& b) {
    return a.isosurface == b.isosurface && a.setting == b.setting && a.low == b.low && a.high == b.high &&
           a.picture == b.picture && a.camera == b.camera &&
           (a.scene == b.scene || sameButFor(a.setting, *a.scene, *b.scene));
}

const CostPlot* CostSurveyor::recall(const Subject& subject) const {
    const auto found = std::find_if(known_.rbegin(), known_.rend(),
                                    [&](const Known& known) { return same(known.subject, subject); });
    return found == known_.rend() ? nullptr : &found->plot;
}

void CostSurveyor::judgeStrips() {
    for (int i = 0; i < panel_->count(); ++i) {
        CostStrip* strip = panel_->slider(i)->strip();
        if (!strip) continue;
        connect(strip, &CostStrip::exposed, this, &CostSurveyor::next,
                static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::UniqueConnection));
        const auto subject = subjectOf(*panel_->slider(i));
        if (!subject)
            strip->clear();
        else if (const CostPlot* plot = recall(*subject))
            strip->setPlot(*plot);
        else
            strip->setOld();
    }
}

void CostSurveyor::next() {
    if (!resting_ || surveying_) return;
    // The one in use comes first, then what is seen, then what can be scrolled to.
    const auto urgency = [](const CostStrip& strip) {
        return strip.hasFocus() ? 3 : !strip.visibleRegion().isEmpty() ? 2 : strip.isVisible() ? 1 : 0;
    };
    CostStrip* wanted = nullptr;
    int most = 0;
    std::optional<Subject> about;
    for (int i = 0; i < panel_->count(); ++i) {
        CostStrip* strip = panel_->slider(i)->strip();
        if (!strip || strip->fresh() || urgency(*strip) <= most) continue;
        auto subject = subjectOf(*panel_->slider(i));
        if (!subject) continue;
        wanted = strip;
        most = urgency(*strip);
        about = std::move(subject);
    }
    if (wanted) start(wanted, *about);
}

void CostSurveyor::start(CostStrip* strip, const Subject& subject) {
    surveying_ = true;
    strip_ = strip;
    subject_ = subject;
    stop_ = std::stop_source();
    CostSurveyRequest request;
    request.view.scene = subject.scene;
    request.view.camera = subject.camera;
    request.view.width = subject.picture.width();
    request.view.height = subject.picture.height();
    request.isosurface = subject.isosurface;
    request.setting = subject.setting;
    request.values = surveyValues(subject.low, subject.high);
    // Something is seen early: the dearest value comes last.
    const bool downwards = subject.setting == StudiedSetting::accuracy;
    const auto dearest =
        downwards ? std::ranges::min_element(request.values) : std::ranges::max_element(request.values);
    if (dearest != request.values.end()) std::rotate(dearest, dearest + 1, request.values.end());
    worker_.submit(
        [this, request, generation = generation_, stop = stop_.get_token()](std::stop_token closing) {
            // Only what other threads leave of the processor.
            lowerThreadPriority();
            const EitherStop either(stop, closing);
            CostSurvey survey(request);
            while (survey.next(either.token())) {
                CostPlot plot = plotOf(survey, request);
                QMetaObject::invokeMethod(
                    this, [this, plot = std::move(plot), generation] { receive(plot, generation); },
                    Qt::QueuedConnection);
            }
            // Where nothing can be measured, that is all there is to say.
            if (survey.complete() || either.requested()) return;
            QMetaObject::invokeMethod(
                this,
                [this, generation] {
                    CostPlot nothing;
                    nothing.complete = true;
                    receive(nothing, generation);
                },
                Qt::QueuedConnection);
        });
}

void CostSurveyor::receive(const CostPlot& plot, quint64 generation) {
    ++measured_;
    if (generation != generation_) return;
    if (strip_) strip_->setPlot(plot);
    if (!plot.complete) return;
    surveying_ = false;
    if (known_.size() >= keptPlots) known_.erase(known_.begin());
    known_.push_back({subject_, plot});
    next();
}

}  // namespace isoscope
