// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

class QAction;
class QDockWidget;
class QMainWindow;

namespace isoscope {

/// The panels around the viewport: text and problems at the left, parameters and functions at the right,
/// plots below. They can be moved, closed, stacked and taken out; the window remembers.
class Docks : public QObject {
    Q_OBJECT
  public:
    struct Contents {
        QWidget *text, *problems, *parameters, *functions, *section, *gradient, *histogram, *accuracy, *ray,
            *effects;
    };
    Docks(QMainWindow* window, const Contents& contents);

    QDockWidget *text, *problems, *parameters, *functions, *section, *gradient, *histogram, *accuracy, *ray,
        *effects;

    /// For the menu: shows or hides each.
    QList<QAction*> actions() const;
    /// Everything visible and in its first place, in proportion to the window.
    void arrange();

  private:
    QList<QDockWidget*> all() const;
    QDockWidget* make(const QString& title, const char* name, QWidget* content);
    QDockWidget* add(const QString& title, const char* name, QWidget* content, Qt::DockWidgetArea area);
    /// Behind the same tabs as `below`.
    QDockWidget* add(const QString& title, const char* name, QWidget* content, QDockWidget* below);

    QMainWindow* window_;
};

}  // namespace isoscope
