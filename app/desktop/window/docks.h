// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

class QAction;
class QDockWidget;
class QMainWindow;

namespace isoscope {

class DockTabs;
class StudyPanels;

/// The panels around the viewport: the text at the left, and parameters, functions and problems below it;
/// plots below the viewport. They can be moved, closed, stacked and taken out; the window remembers.
class Docks : public QObject {
    Q_OBJECT
  public:
    /// The widgets that go into the docks, which own them from then on.
    struct Contents {
        QWidget *text, *problems, *parameters, *functions;
        const StudyPanels& studies;
    };
    Docks(QMainWindow* window, const Contents& contents);

    QDockWidget *text, *problems, *parameters, *functions;
    /// Those of StudyPanels, in their order, and by their names.
    QList<QDockWidget*> studies;
    QDockWidget *section, *gradient, *histogram, *accuracy, *ray, *effects;

    /// For the menu: shows or hides each.
    QList<QAction*> actions() const;
    QList<QDockWidget*> all() const;
    DockTabs* tabs() const { return tabs_; }
    /// Shows a panel in front of those that share its place.
    void bringUp(QDockWidget* dock);
    /// Everything visible and in its first place; for the sizes see PictureRoom.
    void arrange();

  signals:
    /// bringUp() has shown this panel.
    void broughtUp(QDockWidget* dock);

  private:
    QDockWidget* make(const QString& title, const char* name, QWidget* content);
    QDockWidget* study(const char* id) const;
    QDockWidget* add(const QString& title, const char* name, QWidget* content, Qt::DockWidgetArea area);
    /// Behind the same tabs as `below`.
    QDockWidget* add(const QString& title, const char* name, QWidget* content, QDockWidget* below);

    QMainWindow* window_;
    DockTabs* tabs_;
};

}  // namespace isoscope
