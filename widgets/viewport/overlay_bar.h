// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QToolButton;

namespace isoscope {

class ViewOverlay;

/// A box in the upper left corner of the viewport about its overlay: what was counted, or how far the
/// counting is, with a button to stop it. Hidden while there is no overlay. It floats, for a line of its own
/// would change the size of the picture.
class OverlayBar : public QWidget {
    Q_OBJECT
  public:
    OverlayBar(ViewOverlay* overlay, QWidget* viewport);

    /// The line as it stands; empty without an overlay.
    QString text() const;
    /// Shown only while the computing is slow; never null.
    QToolButton* stopButton() const { return stop_; }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    void refresh();
    void place();

    ViewOverlay* overlay_;
    QLabel* text_;
    QProgressBar* progress_;
    QToolButton* stop_;
};

}  // namespace isoscope
