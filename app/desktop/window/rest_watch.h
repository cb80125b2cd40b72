// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

namespace isoscope {

class ParameterPanel;
class Viewport;

/// Says when work in the background may begin, and when it must stop: the window rests when the picture is
/// finished, no slider is held and nothing has changed for a moment.
class RestWatch : public QObject {
    Q_OBJECT
  public:
    RestWatch(Viewport* viewport, ParameterPanel* parameters, QObject* parent);

    /// Whether the window rests: from rested() to moved().
    bool resting() const { return resting_; }

  public slots:
    /// The scene, the view or a panel's visibility has changed.
    void disturb();

  signals:
    /// The window has come to rest; emitted again after each moved().
    void rested();
    /// Once for each rest.
    void moved();

  private:
    void follow();

    Viewport* viewport_;
    QTimer pause_;
    bool dragging_ = false;
    bool resting_ = false;
};

}  // namespace isoscope
