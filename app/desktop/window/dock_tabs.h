// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <QTimer>

class QDockWidget;
class QMainWindow;
class QTabBar;

namespace isoscope {

/// What stands above the docks of a window: a title row where a dock is alone, a tab where several share a
/// place, never both. A tab's context menu closes its panel or takes it out, as the buttons of a title row
/// do.
class DockTabs : public QObject {
    Q_OBJECT
  public:
    DockTabs(QMainWindow* window, const QList<QDockWidget*>& docks);
    /// One more dock of the window.
    void add(QDockWidget* dock);

    /// The row of tabs that shows `dock`; null while the dock is hidden, taken out or alone in its place.
    QTabBar* barOf(const QDockWidget* dock) const;
    /// Docks of one row of tabs, hidden ones left out.
    QList<QDockWidget*> docksOf(const QTabBar* bar) const;
    /// Whether others that are shown share the place of `dock`.
    bool tabbed(QDockWidget* dock) const;

  signals:
    /// A tab was pressed, be it the present one, or a command brought its panel to the front.
    void chosen(QDockWidget* dock);
    /// Rows of tabs came or went, or their docks did.
    void changed();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void watch(QDockWidget* dock);
    void refresh();
    void prepare(QTabBar* bar);
    void showMenu(QTabBar* bar, const QPoint& at);
    QDockWidget* dockAt(const QTabBar* bar, int index) const;

    QMainWindow* window_;
    QList<QDockWidget*> docks_;
    QTimer refreshTimer_;  ///< the window lays out its docks after it told that they changed
};

}  // namespace isoscope
