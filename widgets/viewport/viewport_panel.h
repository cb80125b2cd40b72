// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/render/progressive/progressive_renderer.h"

class QLabel;
class QToolBar;

namespace isoscope {

class OverlayBar;
class Viewport;

/// The viewport and, below, a line that says how far the picture is and what it cost.
class ViewportPanel : public QWidget {
    Q_OBJECT
  public:
    explicit ViewportPanel(QWidget* parent = nullptr);

    /// The viewport inside; never null.
    Viewport* viewport() const { return viewport_; }
    /// For the window's actions, which puts it to its other tools.
    QToolBar* tools() const { return tools_; }
    OverlayBar* overlayBar() const { return overlayBar_; }
    /// The line as it stands, for tests and screen readers.
    QString status() const;

  private:
    void showProgress(const RenderProgress& progress);

    QToolBar* tools_;
    Viewport* viewport_;
    OverlayBar* overlayBar_;
    QLabel* status_;
    QLabel* cost_;
    std::uint64_t finishedJob_ = 0;  ///< the last one
};

/// "1.23 M": a count in at most four digits.
QString shortCount(std::uint64_t count);

}  // namespace isoscope
