// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <QObject>

namespace isoscope {

class SceneEditor;
class SceneSession;

/// Writes settings that a panel found into the text, as one undo step each.
class SettingWriter : public QObject {
    Q_OBJECT
  public:
    SettingWriter(SceneEditor* editor, SceneSession* session, QObject* parent);

    /// Gives isosurface number `isosurface` another max_gradient. A text that is newer than its parse is
    /// parsed first, for the places to be right.
    void setMaxGradient(std::size_t isosurface, double value);

  signals:
    /// For the status line.
    void said(const QString& message);

  private:
    void writeMaxGradient(std::size_t isosurface, double value);

    SceneEditor* editor_;
    SceneSession* session_;
    std::function<void()> waiting_;
};

}  // namespace isoscope
