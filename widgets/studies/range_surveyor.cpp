// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/range_surveyor.h"

#include <algorithm>

#include "core/study/gradient/function_likeness.h"
#include "widgets/background_priority.h"
#include "widgets/either_stop.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"

namespace isoscope {

namespace {

constexpr std::size_t keptRanges = 200;

/// Whether two numbers stand at the same place of the same text.
bool sameNumber(const SceneParameter& a, const SceneParameter& b) {
    return a.role == b.role && a.name == b.name && a.range.file == b.range.file &&
           a.range.begin == b.range.begin && a.range.end == b.range.end;
}

/// The parameters of a scene without the one that varies.
std::vector<double> others(const Scene& scene, int slot) {
    std::vector<double> table = *scene.parameterTable;
    if (slot >= 0 && static_cast<std::size_t>(slot) < table.size()) table[static_cast<std::size_t>(slot)] = 0;
    return table;
}

}  // namespace

bool RangeSurveyor::same(const Question& a, const Question& b) {
    const IsosurfaceSettings &s = a.shape->settings(), &t = b.shape->settings();
    const bool sameThreshold = a.subject.slot == RangeStudy::threshold || s.threshold == t.threshold;
    return a.low == b.low && a.high == b.high && a.subject.slot == b.subject.slot && sameThreshold &&
           s.positivePolarity == t.positivePolarity && sameContainer(s.container, t.container) &&
           sameFunction(*a.shape->tape(), a.others, *b.shape->tape(), b.others);
}

RangeSurveyor::RangeSurveyor(ParameterPanel* panel, QObject* parent) : QObject(parent), panel_(panel) {}

RangeSurveyor::~RangeSurveyor() { stop_.request_stop(); }

void RangeSurveyor::setScene(std::shared_ptr<const Scene> scene) {
    if (scene == scene_) return;
    stop();
    scene_ = std::move(scene);
    if (!scene_) known_.clear();
    for (int i = 0; i < panel_->count(); ++i) {
        ParameterSlider* slider = panel_->slider(i);
        // Its own value does not matter.
        if (slider && !slider->isDragging() && !slider->isPlaying()) slider->setPresenceOld();
    }
}

void RangeSurveyor::stop() {
    surveying_ = false;
    stop_.request_stop();
    ++generation_;
}

std::vector<RangeSurveyor::Job> RangeSurveyor::jobs() const {
    std::vector<Job> jobs;
    const std::vector<RangeSubject> subjects = rangeSubjects(*scene_);
    for (int i = 0; i < panel_->count(); ++i) {
        ParameterSlider* slider = panel_->slider(i);
        if (!slider) continue;
        Job job{slider, {}};
        for (const RangeSubject& subject : subjects)
            if (sameNumber(scene_->parameters[subject.parameter], slider->parameter()))
                job.questions.push_back({subject, scene_->isosurfaces[subject.isosurface].shape,
                                         others(*scene_, subject.slot), slider->minimum(),
                                         slider->maximum()});
        if (!job.questions.empty())
            jobs.push_back(std::move(job));
        else
            slider->setPresence({});
    }
    return jobs;
}

const ParameterRange* RangeSurveyor::recall(const Job& job) const {
    const auto found = std::find_if(known_.rbegin(), known_.rend(), [&](const Known& known) {
        return std::ranges::equal(known.questions, job.questions, same);
    });
    return found == known_.rend() ? nullptr : &found->range;
}

void RangeSurveyor::rest() {
    if (surveying_ || !scene_ || !panel_->isVisible()) return;
    std::vector<Job> open;
    for (Job& job : jobs()) {
        if (const ParameterRange* range = recall(job))
            job.slider->setPresence(*range);
        else
            open.push_back(std::move(job));
    }
    if (open.empty()) return;
    surveying_ = true;
    stop_ = std::stop_source();
    worker_.submit([this, scene = scene_, open = std::move(open), generation = generation_,
                    stop = stop_.get_token()](std::stop_token closing) {
        lowerThreadPriority();
        const EitherStop either(stop, closing);
        for (const Job& job : open) {
            std::vector<ParameterRange> ranges;
            for (const Question& asked : job.questions)
                ranges.push_back(rangeOf(*scene, asked.subject, asked.low, asked.high, {}, either.token()));
            if (either.requested()) return;
            QMetaObject::invokeMethod(
                this, [this, job, range = united(ranges), generation] { receive(job, range, generation); },
                Qt::QueuedConnection);
        }
        QMetaObject::invokeMethod(
            this,
            [this, generation] {
                if (generation == generation_) surveying_ = false;
            },
            Qt::QueuedConnection);
    });
}

void RangeSurveyor::receive(const Job& job, const ParameterRange& range, quint64 generation) {
    if (generation != generation_) return;
    if (known_.size() >= keptRanges) known_.erase(known_.begin());
    known_.push_back({job.questions, range});
    if (job.slider) job.slider->setPresence(range);
}

}  // namespace isoscope
