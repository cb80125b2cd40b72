// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QMainWindow;

namespace isoscope {

class Actions;
class SceneEditor;

/// Sends Cut, Copy, Paste and Select All to the field with the focus, else to the editor.
class ClipboardRouter : public QObject {
    Q_OBJECT
  public:
    /// The parts outlive the router, whose parent the window is.
    ClipboardRouter(QMainWindow* window, SceneEditor* editor, const Actions& actions);

  private:
    void edit(const char* slot);

    QMainWindow* window_;
    SceneEditor* editor_;
};

}  // namespace isoscope
