// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

#include "core/language/sliders/slider_play.h"
#include "widgets/play_clock.h"

namespace isoscope {

class ParameterPanel;
class ParameterSlider;

/// Moves one slider of a panel by itself, by a PlayClock. The text hears of the last value only. Escape, a
/// touch of the slider, or another slider that is to play stop it.
class SliderPlayer : public QObject {
    Q_OBJECT
  public:
    /// The panel owns it.
    explicit SliderPlayer(ParameterPanel* panel);
    ~SliderPlayer() override;

    /// Begins where the slider stands, as it is set to play; another one that plays is stopped, the same one
    /// goes on in its new way. Nothing for a row that cannot.
    void start(int index);
    /// Ends with played()'s last value; nothing when none plays.
    void stop();
    /// Ends without a value: the text is another one.
    void abandon();
    bool isPlaying() const;

  public slots:
    /// The picture of the latest scene is complete.
    void pictureFinished() { clock_.pictureFinished(); }

  signals:
    /// Begun or ended.
    void playingChanged(bool playing);
    /// A value for the picture, not for the text.
    void played(int index, double value);
    /// Stopped with this value, for the text, where it differs from the one at the start.
    void finished(int index, double value);

  private:
    void showNext();
    /// Takes the slider out of play.
    ParameterSlider* release();

    ParameterPanel* panel_;
    QPointer<ParameterSlider> slider_;
    SliderPlay play_;
    double startShare_ = 0;
    double startValue_ = 0;
    PlayClock clock_;
};

}  // namespace isoscope
