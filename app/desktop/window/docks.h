// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <QString>

class QAction;
class QDockWidget;
class QMainWindow;

namespace isoscope {

class DockTabs;

/// The panels around the viewport: the text at the left, and parameters, functions and problems below it;
/// studies below the viewport. They can be moved, closed, stacked and taken out; the window remembers. Which
/// there are is for the rows that it is made of.
class Docks : public QObject {
    Q_OBJECT
  public:
    /// Where a panel lies at first; panels of one place share their tabs.
    enum class Place { upperLeft, lowerLeft, below, right };
    /// One panel.
    struct Row {
        const char* id;  ///< of its place in a stored layout
        QString title;   ///< of its tab
        QString help;    ///< what What's This says
        Place place;
        QWidget* content;     ///< which the dock owns from then on
        bool closed = false;  ///< at first
    };
    Docks(QMainWindow* window, const QList<Row>& rows);
    /// A panel that is made when it is first wanted: where a stored layout has it, else in its place.
    QDockWidget* addLater(const Row& row);

    /// The one of this id; null for none.
    QDockWidget* find(const char* id) const;
    /// Those of this place, in the order of their rows.
    QList<QDockWidget*> at(Place place) const;
    /// All, in the order of their rows.
    QList<QDockWidget*> all() const;
    /// For the menu: shows or hides each.
    QList<QAction*> actions() const;
    DockTabs* tabs() const { return tabs_; }
    /// Shows a panel in front of those that share its place.
    void bringUp(QDockWidget* dock);
    /// Everything in its first place, and visible that is not closed at first; for the sizes see PictureRoom.
    void arrange();

  signals:
    /// bringUp() has shown this panel.
    void broughtUp(QDockWidget* dock);

  private:
    struct Placed {
        Place place;
        QDockWidget* dock;
        bool closed;
    };

    void add(const Row& row);

    QMainWindow* window_;
    QList<Placed> docks_;
    DockTabs* tabs_;
};

}  // namespace isoscope
