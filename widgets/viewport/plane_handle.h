// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <QObject>
#include <QPointF>

#include "core/shapes/transform.h"
#include "widgets/section/section_plane.h"
#include "widgets/viewport/view_projection.h"

class QPainter;

namespace isoscope {

/// The plane of the cross-section, drawn over the picture: what it cuts out of the container, a knob in its
/// middle that moves it along its normal, and one at the end of the normal that turns it.
class PlaneHandle : public QObject {
    Q_OBJECT
  public:
    /// What the mouse holds: a knob, or nothing.
    enum class Grip { none, move, turn };

    using QObject::QObject;

    /// Whether the plane is drawn and can be held; without setPlane() it is not.
    void setShown(bool shown);
    bool shown() const { return shown_; }
    /// `toWorld` takes the coordinates of the function to those of the scene.
    void setPlane(const SectionPlane& plane, const Container& container, const Transform& toWorld);
    /// There is nothing to cut.
    void clear();

    /// What a press at this pixel would take hold of.
    Grip gripAt(const QPointF& pixel, const ViewProjection& view) const;
    void press(const QPointF& pixel, const ViewProjection& view);
    void drag(const QPointF& pixel, const ViewProjection& view);
    void release();
    Grip held() const { return grip_; }
    /// Lights up the knob under the mouse.
    void hover(const QPointF& pixel, const ViewProjection& view);

    /// Draws outline, normal and knobs; nothing while hidden or without a plane. The painter is left as it
    /// was.
    void paint(QPainter& painter, const ViewProjection& view) const;
    /// Where the knobs are; nothing while they cannot be seen.
    std::optional<QPointF> movePixel(const ViewProjection& view) const;
    std::optional<QPointF> turnPixel(const ViewProjection& view) const;

  signals:
    /// The user asks for another position, or another normal.
    void moved(double position);
    void turned(double x, double y, double z);
    /// Something to paint has changed.
    void changed();

  private:
    struct Subject {
        SectionPlane plane;
        Container container;
        Transform toWorld;
    };

    std::optional<QPointF> pixelOf(const glm::dvec3& point, const ViewProjection& view) const;
    /// The length of the normal as it is drawn.
    double reach() const;
    void dragAlong(const QPointF& pixel, const ViewProjection& view);
    void dragAround(const QPointF& pixel, const ViewProjection& view);
    void paintOutline(QPainter& painter, const ViewProjection& view) const;
    void paintKnobs(QPainter& painter, const ViewProjection& view) const;

    bool shown_ = false;
    std::optional<Subject> subject_;
    Grip grip_ = Grip::none;
    Grip hovered_ = Grip::none;
    QPointF pressed_;
    double pressedPosition_ = 0;
    QPointF perUnit_;           ///< pixels that the plane moves on the screen per unit of position
    bool turnsInFront_ = true;  ///< the knob that turns was on the near side of its sphere
};

}  // namespace isoscope
