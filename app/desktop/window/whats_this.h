// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

class QAction;
class QWidget;

namespace isoscope {

class Actions;
class Docks;

/// What Shift+F1 says of every control of the window. The concepts that one has to know have texts of their
/// own: first a sentence without terms, then the terms. Whatever has none says what its tooltip says, or what
/// the panel around it is for.
class WhatsThis : public QObject {
    Q_OBJECT
  public:
    WhatsThis(const Actions& actions, const Docks& docks, QWidget* window);

    /// Rich text; empty for what is no part of the window.
    static QString textOf(const QWidget* widget);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QWidget* window_;
};

}  // namespace isoscope
