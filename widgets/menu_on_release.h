// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QObject>
#include <QPointer>

class QContextMenuEvent;
class QMouseEvent;
class QWidget;

namespace isoscope {

/// Context menus of the whole program open when the right button is released where it was pressed, on every
/// platform. X11 opens them at the press: a drag with the right button then never reaches the widget, and its
/// release chooses the entry that happens to lie there. A drag opens no menu; menus asked for by key come as
/// before.
class MenuOnRelease : public QObject {
    Q_OBJECT
  public:
    explicit MenuOnRelease(QObject* parent);
    ~MenuOnRelease() override;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool hold(QWidget* widget, const QContextMenuEvent& event);
    void follow(const QMouseEvent& event);

    QPointer<QWidget> widget_;                  ///< whose menu waits for the release
    std::unique_ptr<QContextMenuEvent> asked_;  ///< for the menu; null when none waits
};

}  // namespace isoscope
