// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

class QBoxLayout;

namespace isoscope {

/// A spin box for numbers of any size, shown as the scene text would write them. Steps follow a slider's
/// resolution; the wheel counts only with the focus, so that scrolling a panel changes nothing.
class NumberBox : public QDoubleSpinBox {
    Q_OBJECT
  public:
    explicit NumberBox(QWidget* parent = nullptr);
    /// Adds a label and a box to `row`: no wider than the text `widest`, called `name`.
    static NumberBox* addTo(QBoxLayout* row, const QString& label, const QString& name,
                            const QString& widest);

    /// What one step changes; also the place that steps round to.
    void setResolution(double resolution) { resolution_ = resolution; }
    void setIntegral(bool integral) { integral_ = integral; }
    /// How many decimals are shown; -1: as many as the number needs.
    void setPlaces(int places) { places_ = places; }

    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;
    void stepBy(int steps) override;

  protected:
    void wheelEvent(QWheelEvent* event) override;

  private:
    double resolution_ = 0.01;
    bool integral_ = false;
    int places_ = -1;
};

}  // namespace isoscope
