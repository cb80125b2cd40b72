// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/slider_player.h"

#include <algorithm>
#include <QApplication>
#include <QKeyEvent>

#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/timing.h"

namespace isoscope {
namespace {

/// A picture that has not come by now may never come: the next value follows.
constexpr int patience = 5000;
constexpr qint64 framePause = 1'000'000'000 / 60;  // nanoseconds

}  // namespace

SliderPlayer::SliderPlayer(ParameterPanel* panel) : QObject(panel), panel_(panel) {
    next_.setSingleShot(true);
    next_.setTimerType(Qt::PreciseTimer);
    connect(&next_, &QTimer::timeout, this, &SliderPlayer::showNext);
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
    due_ = 0;
    if (goesOn) return;
    slider_ = slider;
    startValue_ = slider->value();
    slider->setPlaying(true);
    connect(slider, &QObject::destroyed, this, &SliderPlayer::abandon);
    qApp->installEventFilter(this);
    emit playingChanged(true);
    awaited_ = false;
    next_.start(timing::drainInterval);
}

ParameterSlider* SliderPlayer::release() {
    next_.stop();
    qApp->removeEventFilter(this);
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
    if (!next_.isActive() && !slider_) return;
    release();
    emit playingChanged(false);
}

void SliderPlayer::pictureFinished() {
    if (!slider_ || !awaited_) return;
    awaited_ = false;
    // What a timer is late is made up for, unless it is much.
    next_.start(static_cast<int>(std::max<qint64>(0, due_ - clock_.nsecsElapsed()) / 1'000'000));
}

void SliderPlayer::showNext() {
    if (!slider_) return;
    const PlayPlace place = playPlace(play_, startShare_, static_cast<double>(clock_.nsecsElapsed()) * 1e-9);
    const double value = slider_->valueAt(place.share);
    const bool moved = value != slider_->value();
    if (moved) {
        slider_->setPlayed(value);
        due_ = std::max(due_ + framePause, clock_.nsecsElapsed());
        awaited_ = true;
        next_.start(patience);
        emit played(panel_->indexOf(slider_), value);
    }
    if (place.ended) return stop();
    if (!moved) next_.start(timing::drainInterval);
}

bool SliderPlayer::eventFilter(QObject*, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() != Qt::Key_Escape || key->modifiers() != Qt::NoModifier ||
        QApplication::activePopupWidget())
        return false;
    // The shortcut that the key may be elsewhere is not to act.
    event->accept();
    if (event->type() == QEvent::KeyPress) stop();
    return true;
}

}  // namespace isoscope
