// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <QRect>
#include <glm/vec3.hpp>
#include <optional>

#include "widgets/viewport/view_projection.h"

class QPainter;

namespace isoscope {

/// The probed point over the picture. Only the surroundings of the mark are painted again when it moves.
class ProbeMark : public QObject {
    Q_OBJECT
  public:
    using QObject::QObject;

    /// Replaces the mark; nothing takes it away.
    void set(const std::optional<glm::dvec3>& point);
    /// In the world; nothing without a mark.
    const std::optional<glm::dvec3>& point() const { return point_; }

    /// Draws the mark where the view shows it.
    void paint(QPainter& painter, const ViewProjection& view) const;
    /// What has to be painted again after changed(): where the mark was, and where it is in this view.
    QRect stale(const ViewProjection& view) const;

  signals:
    /// The mark has moved, come or gone.
    void changed();

  private:
    std::optional<glm::dvec3> point_;
    mutable QRect painted_;  ///< around the mark as it was painted last
};

/// Tells where the mouse is over a widget while no button is held, without taking its events.
class HoverWatch : public QObject {
    Q_OBJECT
  public:
    /// `watched` tracks the mouse and lives as long as its parent, which the watch belongs to, too.
    explicit HoverWatch(QWidget* watched);

  signals:
    /// In pixels of the widget.
    void hovered(QPointF pixel);
    /// The mouse has left, or a button is held.
    void ended();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace isoscope
