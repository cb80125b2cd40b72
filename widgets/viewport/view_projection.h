// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <QPointF>
#include <QSizeF>

#include "core/scene/camera.h"

namespace isoscope {

/// Between the world and the pixels of a widget that shows what a camera sees.
class ViewProjection {
  public:
    /// `camera` has the proportions of the widget.
    ViewProjection(const Camera& camera, const QSizeF& size) : camera_(camera), size_(size) {}

    /// Nothing for what lies behind the camera, for degenerate cameras, and for those whose picture is
    /// curved.
    std::optional<QPointF> pixelOf(const glm::dvec3& point) const;
    /// The way from the eye to a point, of any length; for cameras with a flat picture.
    glm::dvec3 sightTo(const glm::dvec3& point) const;
    /// A direction as the camera is turned: to the right, up, and away from the eye.
    glm::dvec3 turned(const glm::dvec3& direction) const;
    /// The ray through a pixel.
    Ray rayAt(const QPointF& pixel) const;

  private:
    Camera camera_;
    QSizeF size_;
};

}  // namespace isoscope
