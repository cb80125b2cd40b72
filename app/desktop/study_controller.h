// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace isoscope {

class Actions;
class Viewport;

/// Connects the commands of the study tools with the viewport and the panels that they concern.
class StudyController : public QObject {
    Q_OBJECT
  public:
    struct Parts {
        Actions* actions;
        Viewport* viewport;
    };
    StudyController(const Parts& parts, QObject* parent);

  private:
    void connectOverlays();

    Parts parts_;
};

}  // namespace isoscope
