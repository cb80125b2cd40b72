// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/rest_watch.h"

#include <utility>

#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/slider_player.h"
#include "widgets/timing.h"
#include "widgets/viewport/viewport.h"

namespace isoscope {

RestWatch::RestWatch(Viewport* viewport, ParameterPanel* parameters, QObject* parent)
    : QObject(parent), viewport_(viewport) {
    pause_.setSingleShot(true);
    pause_.setInterval(2 * timing::settlePause);
    connect(&pause_, &QTimer::timeout, this, &RestWatch::follow);
    connect(viewport, &Viewport::viewChanged, this, &RestWatch::disturb);
    connect(viewport, &Viewport::progressed, this, [this] {
        if (!viewport_->finished()) disturb();
    });
    connect(viewport, &Viewport::pictureFinished, this, &RestWatch::disturb);
    connect(parameters, &ParameterPanel::dragStarted, this, [this] {
        dragging_ = true;
        disturb();
    });
    connect(parameters->player(), &SliderPlayer::playingChanged, this, [this](bool playing) {
        dragging_ = playing;
        disturb();
    });
    connect(parameters, &ParameterPanel::valueChanged, this, &RestWatch::disturb);
    connect(parameters, &ParameterPanel::dragFinished, this, [this] {
        dragging_ = false;
        disturb();
    });
}

void RestWatch::disturb() {
    if (std::exchange(resting_, false)) emit moved();
    pause_.start();
}

void RestWatch::follow() {
    // Whatever is missing comes with a signal of its own.
    if (dragging_ || !viewport_->finished() || viewport_->picture().isNull()) return;
    resting_ = true;
    emit rested();
}

}  // namespace isoscope
