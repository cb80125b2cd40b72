// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;

namespace isoscope {

/// The line at the foot of a panel that finds something out: what is to be said of it, how far it is, a
/// button that begins or stops it, and further buttons.
class ProgressRow : public QWidget {
    Q_OBJECT
  public:
    /// What accessibility calls the parts, and the tool tip of the bar.
    struct Names {
        QString note, progress, progressTip, button;
    };
    /// Words and tool tip of the button.
    struct Button {
        QString text, toolTip;
    };
    explicit ProgressRow(const Names& names, QWidget* parent = nullptr);

    /// Behind the others.
    void add(QWidget* button);
    /// The bar is seen while something is `working`; `button` is what it offers now.
    void setWorking(bool working, const Button& button);
    /// From 0 to 1.
    void setProgress(double done);

    /// What is said; never null.
    QLabel* note() const { return note_; }
    /// That begins and stops; never null.
    QPushButton* button() const { return button_; }

  private:
    QHBoxLayout* row_;
    QLabel* note_;
    QProgressBar* progress_;
    QPushButton* button_;
};

}  // namespace isoscope
