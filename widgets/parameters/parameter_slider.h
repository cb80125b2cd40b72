// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <QTimer>
#include <QWidget>

#include "core/language/sliders/slider_note.h"
#include "core/language/sliders/slider_play.h"
#include "core/scene/scene.h"
#include "core/study/range/parameter_range.h"

class QGridLayout;
class QLabel;
class QMenu;
class QToolButton;

namespace isoscope {

class BandSlider;
class CostStrip;
class ElidedLabel;
class NumberBox;
class SliderScale;

/// One parameter: name, slider, box with the number, the ends of the range, which a double or right click
/// edits, and a menu for all that a SliderNote keeps. Slider and box never disagree: a value outside the
/// range widens it. An expression shows its text and a button instead.
class ParameterSlider : public QWidget {
    Q_OBJECT
  public:
    explicit ParameterSlider(const SceneParameter& parameter, QWidget* parent = nullptr);
    ~ParameterSlider() override;

    /// Shows another value, range or expression text of the same parameter; emits nothing. While the user
    /// moves the slider, its value and range are left alone. Ends that the parser derived from the value (all
    /// but those of arguments) stay as long as they hold it: a handle that jumps after every drag would be a
    /// nuisance.
    void setParameter(const SceneParameter& parameter) { setParameter(parameter, std::nullopt); }
    /// The same with what the text says about the slider, which counts before all else.
    void setParameter(const SceneParameter& parameter, const std::optional<SliderNote>& note);
    /// Whether setParameter() can show it: the same kind of row.
    bool canShow(const SceneParameter& parameter) const;

    /// The present value; a number that was typed need not lie on a step.
    double value() const { return value_; }
    /// The first value shown; a double click on the name goes back to it.
    double initialValue() const { return initial_; }
    /// Another one: of a row that was there before.
    void setInitialValue(double value);
    double minimum() const;
    double maximum() const;
    /// Set by the user, as changeNote(). Ignored unless finite and minimum < maximum (and > 0 on a log
    /// scale).
    void setRange(double minimum, double maximum);

    /// How the slider moves, as a note says it.
    SliderNote note() const;
    bool hasNote() const { return note_.has_value(); }
    /// The user wants another one, or none; stays until the text says something else. Ignored unless usable.
    void changeNote(const std::optional<SliderNote>& note);
    bool isLocked() const { return note_ && note_->locked; }
    /// Decimals that the value is written with; -1: as many as it needs.
    int decimals() const { return note_ ? note_->decimals : -1; }
    /// Any value of the range.
    double randomValue() const;

    /// How it moves by itself; what a menu of its button chooses.
    const SliderPlay& play() const { return play_; }
    void setPlay(const SliderPlay& play);
    /// Shows the button that asks to play, and offers keys; who does so answers playRequested() and
    /// keyRequested().
    void offerPlay();
    bool canPlay() const;
    /// It moves by itself, by setPlayed(); any touch asks to stop that.
    void setPlaying(bool playing);
    bool isPlaying() const { return playing_; }
    /// Shows a value while it plays; emits nothing.
    void setPlayed(double value);
    /// How far the value is from the lower end to the upper one, 0 to 1, and the value that is so far.
    double share() const;
    double valueAt(double share) const;
    bool isDragging() const { return dragging_; }
    /// Shows a value that was changed elsewhere; emits nothing.
    void setValue(double value);
    /// The smallest step that matters at the present value.
    double resolution() const;
    QString name() const;
    /// "f_torus Major Radius", as assistive programs read it.
    QString fullName() const;
    const SceneParameter& parameter() const { return parameter_; }
    /// What the values cost, under the sliders of accuracy and max_gradient; null for others.
    CostStrip* strip() const { return strip_; }

    /// Shades the values for which there is a surface; nothing that is known: shades none.
    void setPresence(const ParameterRange& presence);
    /// What is shaded may not hold any more.
    void setPresenceOld();
    const ParameterRange& presence() const { return presence_; }
    /// Null for an expression.
    BandSlider* slider() const { return slider_; }

  signals:
    /// The user moved it; never by setParameter().
    void valueChanged(double value);
    /// Pressed, or the first of several keyboard, wheel or box changes ...
    void dragStarted();
    /// ... and released, or 400 ms after the last of them.
    void dragFinished();
    void replaceExpressionRequested();
    /// It is to play, or to stop.
    void playRequested(bool on);
    /// The timeline is to keep its value.
    void keyRequested();
    /// changeNote() was done.
    void noteChanged(const std::optional<isoscope::SliderNote>& note);

  public slots:
    /// Back to initialValue(), as a change by the user; does nothing for an expression or a locked slider.
    void resetToInitial();
    /// Moved by the user elsewhere: as a change in the box; settle() ends a run of them.
    void moveTo(double value) { userSet(value); }
    /// To any value of the range, as resetToInitial().
    void randomise();
    /// Opens the fields of range, step and scale.
    void editNote();
    /// Ends a run of changes by keyboard, wheel or box now; a handle that is held goes on.
    void settle() { endChange(); }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

  private:
    void buildSlider();
    void buildButtons();
    void buildExpression();
    /// Sizes that depend on the font.
    void fitLetters();
    void openMenu(const QPoint& place);
    void fillMenu(QMenu& menu);
    void fillPlayMenu(QMenu& menu);
    /// Before the user changes anything.
    void stopPlaying();
    SliderScale proposedScale() const;
    void showNote();
    void setLocked(bool locked);
    void buildStrip(QGridLayout* layout);
    void showValue();
    void showPresence();
    void showTexts();
    void userSet(double value);
    void beginChange();
    void endChange();
    bool sliderEvent(QEvent* event);
    void editEnd(QLabel* end);
    void moveEnd(QLabel* end, double value);

    SceneParameter parameter_;
    std::unique_ptr<SliderScale> scale_;
    double value_ = 0;
    double initial_ = 0;
    std::optional<SliderNote> note_;
    SliderPlay play_;
    bool playing_ = false;
    bool playOffered_ = false;
    bool noteOfText_ = false;  ///< else the user changed it, and the text does not know yet or cannot
    bool upToDate_ = false;    ///< all that parameter_ and its note say is shown
    bool dragging_ = false;
    bool pressed_ = false;
    QTimer settle_;
    QLabel* name_ = nullptr;
    QLabel* minimum_ = nullptr;
    QLabel* maximum_ = nullptr;
    QLabel* expression_ = nullptr;
    QToolButton* replace_ = nullptr;
    QToolButton* playButton_ = nullptr;
    QToolButton* lock_ = nullptr;  ///< seen while the slider is locked
    QToolButton* more_ = nullptr;
    BandSlider* slider_ = nullptr;
    ParameterRange presence_;
    bool presenceOld_ = false;
    NumberBox* box_ = nullptr;
    CostStrip* strip_ = nullptr;
    ElidedLabel* cost_ = nullptr;  ///< what the strip says about the present value
};

}  // namespace isoscope
