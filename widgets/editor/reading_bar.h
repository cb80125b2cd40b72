// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QProgressBar;

namespace isoscope {

class ElidedLabel;

/// The line above the text while reading it takes long: how far it is, and a button that ends it. Hidden
/// otherwise.
class ReadingBar : public QFrame {
    Q_OBJECT
  public:
    explicit ReadingBar(QWidget* parent = nullptr);

    /// `share` of the text, from 0 to 1; loops lead back.
    void showProgress(double seconds, qulonglong steps, double share);
    QString text() const;

  signals:
    /// The button was pressed; the bar stays until its owner hides it.
    void stopRequested();

  private:
    ElidedLabel* text_;
    QProgressBar* share_;
};

}  // namespace isoscope
