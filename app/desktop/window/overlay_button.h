// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QList>
#include <QToolButton>

namespace isoscope {

/// Offers the overlays of the picture in a menu and tells which one is on, whoever chose it. As wide as the
/// longest name, for its neighbours must not move under the mouse; the arrow of the menu follows the name.
class OverlayButton : public QToolButton {
    Q_OBJECT
  public:
    explicit OverlayButton(const QList<QAction*>& choices, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    /// Where the name ends, and the arrow behind it; without a name the arrow is the style's.
    int nameEnd() const;
    QRect arrow() const;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QList<QAction*> choices_;
};

}  // namespace isoscope
