// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/scene/orbit_view.h"
#include "widgets/section/section_panel.h"
#include "widgets/state_history.h"

namespace isoscope {

class Actions;
class SceneEditor;
class ViewController;
class Viewport;

/// One history for all that a hand does: the text and its sliders, the view, the plane of the cross-section.
/// Undo and Redo are there when there is something to undo or redo.
class HistoryController : public QObject {
    Q_OBJECT
  public:
    /// What takes part in the history; the controller owns none of them.
    struct Parts {
        SceneEditor* editor;
        Viewport* viewport;
        SectionPanel* section;
        Actions* actions;
        ViewController* views;
    };

    /// The parts must outlive the controller.
    explicit HistoryController(const Parts& parts, QObject* parent = nullptr);

    /// What the view does from here on is no step ...
    void hold() { held_ = true; }
    /// ... until now: all of it becomes one, which is a part of the last change of the text where `joined`.
    /// Whether there is one.
    bool release(bool joined);

  private:
    void connectView();
    void followView(bool joined);
    void connectPlane();
    void tellAvailable();

    Parts parts_;
    bool held_ = false;
    bool joinView_ = false;  ///< the next view is a part of the last change of the text
    Camera home_;            ///< the text's camera, as far as the view has followed it
    StateHistory<OrbitView::State> view_;
    StateHistory<SectionPanel::State> plane_;
};

}  // namespace isoscope
