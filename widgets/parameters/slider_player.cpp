// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/slider_player.h"

#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"

namespace isoscope {

SliderPlayer::SliderPlayer(ParameterPanel* panel) : QObject(panel), panel_(panel) {
    connect(&clock_, &PlayClock::due, this, &SliderPlayer::showNext);
    connect(&clock_, &PlayClock::escaped, this, &SliderPlayer::stop);
}

SliderPlayer::~SliderPlayer() = default;

bool SliderPlayer::isPlaying() const { return slider_ != nullptr; }

void SliderPlayer::start(int index) {
    ParameterSlider* slider = panel_->slider(index);
    if (!slider || !slider->canPlay()) return stop();
    const bool goesOn = slider == slider_;
    if (!goesOn) panel_->settle();
    play_ = slider->play();
    startShare_ = slider->share();
    clock_.start();
    if (goesOn) return;
    slider_ = slider;
    startValue_ = slider->value();
    slider->setPlaying(true);
    connect(slider, &QObject::destroyed, this, &SliderPlayer::abandon);
    emit playingChanged(true);
}

ParameterSlider* SliderPlayer::release() {
    clock_.stop();
    ParameterSlider* slider = slider_;
    slider_ = nullptr;
    if (!slider) return nullptr;
    slider->disconnect(this);
    slider->setPlaying(false);
    return slider;
}

void SliderPlayer::stop() {
    if (!slider_) return;
    const ParameterSlider* slider = release();
    const int index = panel_->indexOf(slider);
    if (index >= 0 && slider->value() != startValue_) emit finished(index, slider->value());
    emit playingChanged(false);
}

void SliderPlayer::abandon() {
    if (!clock_.isRunning() && !slider_) return;
    release();
    emit playingChanged(false);
}

void SliderPlayer::showNext() {
    if (!slider_) return;
    const PlayPlace place = playPlace(play_, startShare_, clock_.seconds());
    const double value = slider_->valueAt(place.share);
    const bool moved = value != slider_->value();
    clock_.tellShown(moved);
    if (moved) {
        slider_->setPlayed(value);
        emit played(panel_->indexOf(slider_), value);
    }
    if (place.ended) stop();
}

}  // namespace isoscope
