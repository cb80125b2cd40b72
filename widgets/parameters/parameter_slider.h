// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QTimer>
#include <QWidget>

#include "core/scene/scene.h"

class QGridLayout;
class QLabel;
class QSlider;
class QToolButton;

namespace isoscope {

class CostStrip;
class ElidedLabel;
class NumberBox;
class SliderScale;

/// One parameter: name, slider, box with the number, and the ends of the range, which a double or right click
/// edits. Slider and box never disagree: a value outside the range widens it. An expression shows its text
/// and a button instead.
class ParameterSlider : public QWidget {
    Q_OBJECT
  public:
    explicit ParameterSlider(const SceneParameter& parameter, QWidget* parent = nullptr);
    ~ParameterSlider() override;

    /// Shows another value, range or expression text of the same parameter; emits nothing. While the user
    /// moves the slider, its value and range are left alone. Ends that the parser derived from the value (all
    /// but those of arguments) stay as long as they hold it: a handle that jumps after every drag would be a
    /// nuisance.
    void setParameter(const SceneParameter& parameter);
    /// Whether setParameter() can show it: the same kind of row.
    bool canShow(const SceneParameter& parameter) const;

    /// The present value; a number that was typed need not lie on a step.
    double value() const { return value_; }
    /// The first value shown; a double click on the name goes back to it.
    double initialValue() const { return initial_; }
    double minimum() const;
    double maximum() const;
    /// Set by the user; stays until the widget goes. Ignored unless finite and minimum < maximum (and > 0 on
    /// a log scale).
    void setRange(double minimum, double maximum);
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

  signals:
    /// The user moved it; never by setParameter().
    void valueChanged(double value);
    /// Pressed, or the first of several keyboard, wheel or box changes ...
    void dragStarted();
    /// ... and released, or 400 ms after the last of them.
    void dragFinished();
    void replaceExpressionRequested();

  public slots:
    /// Back to initialValue(), as a change by the user; does nothing for an expression.
    void resetToInitial();
    /// Ends a run of changes by keyboard, wheel or box now; a handle that is held goes on.
    void settle() { endChange(); }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

  private:
    void buildSlider();
    void buildExpression();
    void buildStrip(QGridLayout* layout);
    void showValue();
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
    bool userRange_ = false;
    bool dragging_ = false;
    bool pressed_ = false;
    QTimer settle_;
    QLabel* name_ = nullptr;
    QLabel* minimum_ = nullptr;
    QLabel* maximum_ = nullptr;
    QLabel* expression_ = nullptr;
    QToolButton* replace_ = nullptr;
    QSlider* slider_ = nullptr;
    NumberBox* box_ = nullptr;
    CostStrip* strip_ = nullptr;
    ElidedLabel* cost_ = nullptr;  ///< what the strip says about the present value
};

}  // namespace isoscope
