// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QObject>
#include <QPointF>
#include <QString>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "widgets/viewport/view_projection.h"

class QPainter;

namespace isoscope {

/// A place of the scene that is worth seeing.
struct PlaceMark {
    glm::dvec3 place{0};  ///< in the world
    double reach = 1;     ///< how far its surroundings go: what a view of it should show
    QString label;
    QColor color;
};

/// Marked places over the picture, each with a label beside it while there is room.
class PlaceMarks : public QObject {
    Q_OBJECT
  public:
    using QObject::QObject;

    /// Replaces all marks; emits changed() when any of them differs.
    void set(std::vector<PlaceMark> marks);
    const std::vector<PlaceMark>& marks() const { return marks_; }

    /// The mark under a pixel.
    std::optional<std::size_t> markAt(const QPointF& pixel, const ViewProjection& view) const;
    /// Draws the marks that are in view; labels are left out when there are many of them.
    void paint(QPainter& painter, const QRect& area, const ViewProjection& view) const;

  signals:
    /// Something to paint has changed.
    void changed();

  private:
    std::vector<PlaceMark> marks_;
};

/// A cross in a ring, seen on light and dark; `label` beside it, inside `area`.
void paintPlaceMark(QPainter& painter, const QRect& area, const QPointF& at, const QColor& color,
                    const QString& label);

}  // namespace isoscope
