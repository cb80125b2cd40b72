// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QWidget>

#include "core/scene/scene.h"

namespace isoscope {

struct ProbedPoint;

/// A panel below the picture that shows something of the scene at hand. The window tells all of them the
/// same; a panel takes what it needs.
class StudyPanel : public QWidget {
    Q_OBJECT
  public:
    using QWidget::QWidget;

    /// What is shown from now on; null for a new document.
    virtual void setScene(std::shared_ptr<const Scene>) {}
    /// The view, and its size in pixels.
    virtual void setView(const Camera&, QSize) {}
    /// Whether anybody can see it: not while it is closed or behind another tab.
    virtual void setActive(bool) {}
    /// Whether nothing moves, so that long work may be under way.
    virtual void setResting(bool) {}
    /// The point that is probed here, in another panel or in the picture; null for none.
    virtual void showProbe(const ProbedPoint*) {}
    /// Another document is shown from now on: nothing of what was chosen for the old one stays.
    virtual void leaveDocument() {}
    /// Whether what can be seen of the panel is drawn and will not change by itself.
    virtual bool settled() const { return true; }
    /// Ends all work: the program ends.
    virtual void endWork() {
        setActive(false);
        setScene({});
    }

  signals:
    /// For the status line.
    void said(const QString& message);
    /// Mouse or keys probe this place, in the coordinates of that isosurface's function ...
    void probed(std::size_t isosurface, const glm::dvec3& place);
    /// ... and no place any more.
    void probeEnded();
};

}  // namespace isoscope
