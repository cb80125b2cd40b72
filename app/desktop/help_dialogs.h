// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QList>

class QAction;

namespace isoscope {

/// All commands that have keys, and what mouse and keys do in the viewport and the editor. Deletes itself
/// when closed.
class ShortcutsDialog : public QDialog {
    Q_OBJECT
  public:
    ShortcutsDialog(const QList<QAction*>& actions, QWidget* parent);
};

/// Name, version, licence and the libraries in use. Deletes itself when closed.
class AboutDialog : public QDialog {
    Q_OBJECT
  public:
    explicit AboutDialog(QWidget* parent);
};

}  // namespace isoscope
