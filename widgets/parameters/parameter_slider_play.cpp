// SPDX-License-Identifier: GPL-3.0-or-later
// Of ParameterSlider: how it moves by itself.
#include <algorithm>
#include <cmath>
#include <QActionGroup>
#include <QMenu>
#include <QToolButton>

#include "widgets/icons.h"
#include "widgets/numbers/number_text.h"
#include "widgets/numbers/slider_scale.h"
#include "widgets/parameters/parameter_slider.h"

namespace isoscope {

void ParameterSlider::offerPlay() {
    playOffered_ = true;
    showNote();
}

bool ParameterSlider::canPlay() const { return slider_ && !isLocked() && !parameter_.implied; }

void ParameterSlider::setPlay(const SliderPlay& play) {
    play_ = play;
    if (playing_) emit playRequested(true);
}

void ParameterSlider::setPlaying(bool playing) {
    endChange();
    playing_ = playing;
    playButton_->setChecked(playing);
    playButton_->setIcon(themeIcon(playing ? "media-playback-stop" : "media-playback-start"));
    showTexts();
}

void ParameterSlider::setPlayed(double value) {
    value_ = value;
    parameter_.value = value;
    showValue();
}

double ParameterSlider::share() const {
    return static_cast<double>(scale_->step(value_)) / std::max(1, scale_->steps());
}

double ParameterSlider::valueAt(double share) const {
    const int step = static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * scale_->steps()));
    const double value = scale_->value(step);
    return decimals() < 0 ? value : numberTextWith(value, decimals()).toDouble();
}

void ParameterSlider::stopPlaying() {
    if (playing_) emit playRequested(false);
}

void ParameterSlider::fillPlayMenu(QMenu& menu) {
    struct Way {
        PlayMode mode;
        QString text, help;
    };
    auto* ways = new QActionGroup(&menu);
    for (const Way& way : {Way{PlayMode::pingPong, tr("Back and forth"), tr("Turns round at each end")},
                           Way{PlayMode::loop, tr("Round and round"), tr("Begins at the lower end again")},
                           Way{PlayMode::once, tr("Once"), tr("Stops at the upper end")}}) {
        QAction* action = menu.addAction(way.text, this, [this, mode = way.mode] {
            setPlay({mode, play_.seconds});
        });
        action->setToolTip(way.help);
        action->setCheckable(true);
        action->setChecked(play_.mode == way.mode);
        ways->addAction(action);
    }
    menu.addSeparator();
    auto* speeds = new QActionGroup(&menu);
    for (const double seconds : {1.0, 2.0, 4.0, 8.0, 16.0, 60.0}) {
        QAction* action = menu.addAction(tr("%1 s from end to end").arg(seconds), this, [this, seconds] {
            setPlay({play_.mode, seconds});
        });
        action->setToolTip(tr("How fast it plays"));
        action->setCheckable(true);
        action->setChecked(play_.seconds == seconds);
        speeds->addAction(action);
    }
}

}  // namespace isoscope
