// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <QObject>
#include <vector>

#include "core/shapes/rays/container.h"
#include "core/shapes/transform.h"
#include "widgets/viewport/view_projection.h"

class QPainter;
class QRect;

namespace isoscope {

struct Scene;

/// Lines over the picture that tell where one is: the containers of the isosurfaces, the axes of the scene
/// with their names, and in a corner how the view is turned. Drawn by the projection of the camera, so that
/// cameras whose picture is curved show none.
class SceneGuides : public QObject {
    Q_OBJECT
  public:
    using QObject::QObject;

    /// Whose containers are drawn; null for none.
    void setScene(const Scene* scene);
    void setContainersShown(bool shown);
    bool containersShown() const { return containersShown_; }
    void setAxesShown(bool shown);
    bool axesShown() const { return axesShown_; }

    /// Draws what is shown into `area`, the picture's rectangle. The painter is left as it was.
    void paint(QPainter& painter, const ViewProjection& view, const QRect& area) const;

    /// Outlines beyond these are left out: they would hide the picture.
    static constexpr std::size_t mostContainers = 100;

  signals:
    /// Something to paint has changed.
    void changed();

  private:
    struct Placed {
        Container container;
        Transform toWorld;
    };

    void paintContainer(QPainter& painter, const ViewProjection& view, const Placed& placed) const;
    void paintAxes(QPainter& painter, const ViewProjection& view, const QRect& area) const;
    void paintGizmo(QPainter& painter, const ViewProjection& view, const QRect& area) const;

    std::vector<Placed> containers_;
    double reach_ = 1;  ///< how far the axes go on either side of the origin
    bool containersShown_ = false;
    bool axesShown_ = false;
};

}  // namespace isoscope
