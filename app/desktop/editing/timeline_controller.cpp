// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/editing/timeline_controller.h"

#include <algorithm>
#include <cmath>

#include "app/desktop/editing/history_controller.h"
#include "core/language/sliders/slider_names.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/numbers/number_text.h"
#include "widgets/parameters/parameter_binding.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/parameters/slider_player.h"
#include "widgets/timeline/timeline_panel.h"
#include "widgets/viewport/viewport.h"

namespace isoscope {

namespace {

/// Digits of a camera's key: degrees, and lengths as a share of the distance of the view.
constexpr double degreeResolution = 1e-3;
constexpr double lengthResolution = 1e-5;
/// A number that agrees with its keys to this share does not differ from them.
constexpr double sameNumber = 1e-9;

/// Numbers between keys are rounded to this share of what a slider tells apart.
constexpr double roundedShare = 0.1;

bool differs(double a, double b) { return std::abs(a - b) > sameNumber * std::max(1.0, std::abs(b)); }

/// A pose with numbers that are short in the text.
CameraPose rounded(const CameraPose& pose) {
    const double resolution = pose.distance * lengthResolution;
    CameraPose round = pose;
    for (double* angle : {&round.azimuth, &round.elevation, &round.angle})
        *angle = numberText(*angle, degreeResolution).toDouble();
    for (double* length : {&round.distance, &round.lookAt.x, &round.lookAt.y, &round.lookAt.z})
        *length = numberText(*length, resolution).toDouble();
    return round;
}

}  // namespace

TimelineController::TimelineController(const Parts& parts, QObject* parent)
    : QObject(parent),
      parts_(parts),
      frames_(parts.editor->history(), {[this] { return frame_; },
                                        [this](int frame) {
                                            frame_ = frame;
                                            setMoment(frame);
                                            parts_.panel->setFrame(frame);
                                            if (asksForClock_) parts_.binding->keepPlayed({});
                                        },
                                        [this] { return moving_; }}) {
    connect(parts.session, &SceneSession::parsed, this, &TimelineController::adopt);
    connect(parts.editor, &SceneEditor::textLoaded, this, &TimelineController::forget);
    // Whoever changes the text, or a slider, takes over.
    connect(parts.editor, &SceneEditor::textEdited, this, &TimelineController::settle, Qt::QueuedConnection);
    connect(parts.parameters, &ParameterPanel::dragStarted, this, &TimelineController::settle);
    connect(parts.parameters->player(), &SliderPlayer::playingChanged, this, [this](bool playing) {
        if (playing) settle();
    });
    connect(parts.parameters, &ParameterPanel::keyRequested, this, &TimelineController::setKeyForNumber);
    // A camera that the text moves by clock takes the view with it; that of the keys counts.
    connect(parts.session, &SceneSession::sceneChanged, this, [this] {
        if (moving_) showCamera(frame_);
    });
    connect(&clock_, &PlayClock::due, this, &TimelineController::showNext);
    connect(&clock_, &PlayClock::escaped, this, &TimelineController::settle);
    connect(parts.binding, &ParameterBinding::playedInVain, &clock_, &PlayClock::pictureFinished);
    connect(parts.viewport, &Viewport::progressed, this, [this](const RenderProgress& progress) {
        if (progress.finished) clock_.pictureFinished();
    });
    connectPanel();
}

TimelineController::~TimelineController() = default;

void TimelineController::connectPanel() {
    const TimelinePanel* panel = parts_.panel;
    connect(panel, &TimelinePanel::framePicked, this, [this](int frame) {
        if (isPlaying()) settle();
        begin();
        show(frame);
    });
    connect(panel, &TimelinePanel::frameSettled, this, [this] {
        if (!isPlaying()) settle();
    });
    connect(panel, &TimelinePanel::playRequested, this, &TimelineController::play);
    connect(panel, &TimelinePanel::numberKeyRequested, this, &TimelineController::setKeyForNumber);
    connect(panel, &TimelinePanel::cameraKeyRequested, this, &TimelineController::setKeyForCamera);
    connect(panel, &TimelinePanel::changedKeysRequested, this, &TimelineController::setChangedKeys);
    connect(panel, &TimelinePanel::timelineChanged, this, &TimelineController::write);
}

void TimelineController::adopt(const std::shared_ptr<const ParseResult>& result, quint64 revision) {
    if (revision != parts_.editor->revision()) return;
    sources_ = result->sources;
    QStringList names;
    for (const auto& [name, value] : parts_.parameters->presetValues()) names << QString::fromStdString(name);
    parts_.panel->setNumbers(names);
    readText();
}

void TimelineController::readText() {
    animation_ = Animation(timelineOf(parts_.editor->utf8()), parts_.binding->parameters());
    parts_.panel->setTimeline(animation_.timeline(), animation_.missing());
}

void TimelineController::forget() {
    clock_.stop();
    parts_.panel->setPlaying(false);
    if (std::exchange(moving_, false)) {
        parts_.history->release(false);
        emit movingChanged(false);
    }
    shown_.clear();
    sources_.reset();
    asksForClock_ = false;
    animation_ = Animation(timelineOf(parts_.editor->utf8()), {});
    frame_ = animation_.timeline().frames.first;
    parts_.panel->setTimeline(animation_.timeline(), {});
    parts_.panel->setFrame(frame_);
    frames_.reset();
}

void TimelineController::begin() {
    if (moving_) return;
    parts_.parameters->settle();
    moving_ = true;
    shown_.clear();
    asksForClock_ = sources_ && isoscope::asksForClock(*sources_);
    parts_.history->hold();
    emit movingChanged(true);
}

void TimelineController::setMoment(int frame) {
    const FrameSequence& frames = animation_.timeline().frames;
    parts_.session->setMoment(SceneSession::Moment{frames.clock(frame), frame, frames.first, frames.last});
}

bool TimelineController::showCamera(int frame) {
    if (!animation_.movesCamera()) return false;
    const Camera camera = animation_.camera(parts_.viewport->home(), frame);
    if (camera == parts_.viewport->camera()) return false;
    parts_.viewport->showCamera(camera, Viewport::Drawing::moving);
    return true;
}

bool TimelineController::show(int frame) {
    frame_ = frame;
    setMoment(frame);
    std::vector<std::pair<int, double>> values;
    for (auto [index, value] : animation_.values(frame)) {
        const int number = static_cast<int>(index);
        // Between keys no digits that the slider could not tell apart.
        const ParameterSlider* slider = parts_.parameters->slider(number);
        if (slider && !animation_.hasKey(index, frame))
            value = roundToResolution(value, slider->resolution() * roundedShare);
        values.emplace_back(number, parts_.parameters->textFor(number, value).toDouble());
    }
    const bool numbersMove = values != shown_ || asksForClock_;
    if (!numbersMove) return showCamera(frame);
    shown_ = std::move(values);
    for (const auto& [index, value] : shown_) parts_.parameters->setValue(index, value);
    // The picture of the old numbers from the new view is not asked for.
    if (animation_.movesCamera())
        parts_.viewport->showCamera(animation_.camera(parts_.viewport->home(), frame),
                                    Viewport::Drawing::withScene);
    parts_.binding->showPlayed(shown_, asksForClock_);
    return true;
}

void TimelineController::settle() {
    clock_.stop();
    parts_.panel->setPlaying(false);
    if (!std::exchange(moving_, false)) return;
    const int before = parts_.editor->history()->textState();
    if (asksForClock_ || !shown_.empty()) parts_.binding->keepPlayed(shown_);
    const bool written = parts_.editor->history()->textState() != before;
    const bool turned = parts_.history->release(written);
    frames_.changed(written || turned);
    frames_.end();
    emit movingChanged(false);
}

void TimelineController::play(bool on) {
    if (!on) return settle();
    begin();
    const FrameSequence& frames = animation_.timeline().frames;
    playedFrom_ = frame_ >= frames.last || frame_ < frames.first ? frames.first : frame_;
    parts_.panel->setPlaying(true);
    clock_.start();
}

void TimelineController::showNext() {
    const FrameSequence& frames = animation_.timeline().frames;
    const double gone = std::floor(clock_.seconds() * animation_.timeline().rate);
    const double count = double(frames.last) - frames.first + 1;
    const double way = playedFrom_ - frames.first + gone;
    const bool ended = !parts_.panel->loops() && way >= count - 1;
    const int frame =
        frames.first + static_cast<int>(ended ? count - 1 : way - count * std::floor(way / count));
    if (frame != frame_) {
        parts_.panel->setFrame(frame);
        clock_.tellShown(show(frame));
    } else {
        clock_.tellShown(false);
    }
    if (ended) settle();
}

Easing TimelineController::easingFor(const std::string& name) const {
    Easing easing = Easing::smooth;
    if (const KeyTrack* track = animation_.timeline().track(name))
        for (const Key& key : track->keys)
            if (key.frame <= frame_) easing = key.easing;
    return easing;
}

void TimelineController::putNumber(Timeline& timeline, const std::string& name, double value) const {
    timeline.putKey(name, {frame_, value, easingFor(name)});
}

void TimelineController::putCamera(Timeline& timeline) const {
    const Camera& camera = parts_.viewport->camera();
    const auto& names = cameraTrackNames();
    const KeyTrack* azimuth = timeline.track(names.front());
    const CameraPose pose =
        rounded(poseOf(camera, parts_.viewport->view().pivot, azimuth ? azimuth->value(frame_) : 0));
    const Camera& home = parts_.viewport->home();
    const auto numbers = poseNumbers(pose);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::string name(names[i]);
        // The angle of view is the text's, unless it was changed.
        const bool angle = i + 1 == numbers.size();
        if (angle && !timeline.track(name) &&
            std::abs(pose.angle - poseOf(home, home.lookAt).angle) < degreeResolution)
            continue;
        putNumber(timeline, name, numbers[i]);
    }
}

void TimelineController::setKeyForNumber(const QString& name) {
    settle();
    parts_.parameters->settle();
    Timeline timeline = timelineOf(parts_.editor->utf8());
    for (const auto& [known, value] : parts_.parameters->presetValues())
        if (known == name.toStdString()) putNumber(timeline, known, value);
    write(timeline);
}

void TimelineController::setKeyForCamera() {
    settle();
    Timeline timeline = timelineOf(parts_.editor->utf8());
    putCamera(timeline);
    write(timeline);
}

bool TimelineController::cameraDiffers() const {
    if (!animation_.movesCamera()) return false;
    const Camera& now = parts_.viewport->camera();
    const Camera keyed = animation_.camera(parts_.viewport->home(), frame_);
    const auto apart = [](const glm::dvec3& a, const glm::dvec3& b) {
        return differs(a.x, b.x) || differs(a.y, b.y) || differs(a.z, b.z);
    };
    return apart(now.location, keyed.location) || apart(now.direction, keyed.direction);
}

void TimelineController::setChangedKeys() {
    settle();
    parts_.parameters->settle();
    Timeline timeline = timelineOf(parts_.editor->utf8());
    for (const auto& [name, value] : parts_.parameters->presetValues()) {
        const KeyTrack* track = timeline.track(name);
        if (track && differs(value, track->value(frame_))) putNumber(timeline, name, value);
    }
    if (cameraDiffers()) putCamera(timeline);
    if (timeline == animation_.timeline())
        emit said(tr("Nothing differs from its keys at this frame."));
    else
        write(timeline);
}

void TimelineController::write(const Timeline& wanted) {
    Timeline timeline = wanted;
    timeline.stated = true;
    const std::vector<TextEdit> edits = timelineEdits(parts_.editor->utf8(), timeline);
    if (!edits.empty()) parts_.binding->changeComments(edits);
    readText();
    // A range that was made smaller takes the frame along.
    const FrameSequence& frames = animation_.timeline().frames;
    const int frame = std::clamp(frame_, frames.first, frames.last);
    if (frame == frame_) return;
    begin();
    parts_.panel->setFrame(frame);
    show(frame);
    settle();
}

}  // namespace isoscope
