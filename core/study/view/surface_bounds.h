// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/scene/scene.h"
#include "core/study/view/isosurface_reach.h"

namespace isoscope {

struct Composition;

/// How far reaches what a scene shows: the surfaces themselves, not their containers. Isosurfaces by proof
/// (IsosurfaceReach), balls, tori and cones exactly, other shapes by their boxes, sets of them by their
/// parts. Left out, unless there is nothing else: objects without an end, and those around the scene's own
/// camera (skies, rooms). Not for several threads at once.
class SurfaceBounds {
  public:
    explicit SurfaceBounds(std::shared_ptr<const Scene> scene, ReachSettings settings = {},
                           std::stop_token stop = {});

    /// No point p of what is shown has a larger direction . p; -infinity when nothing is shown, infinite only
    /// when all that is there has no end.
    double reach(const glm::dvec3& direction);
    /// The smallest box around it, as far as proven; low > high when nothing is shown.
    Bounds box();

    /// Boxes that isosurfaces were divided into.
    std::uint64_t boxes() const;

  private:
    double reach(const ShapePointer& shape, const glm::dvec3& direction, double known);
    /// `limit`: how far the box around what is made so reaches, where no part has to be asked.
    double reachOfWrapped(const Composition& made, const glm::dvec3& direction, double known, double limit);
    double reachOfParts(const Composition& made, const glm::dvec3& direction, double known, double limit);

    std::shared_ptr<const Scene> scene_;
    ReachSettings settings_;
    std::stop_token stop_;
    std::vector<ShapePointer> shown_;
    std::map<const Isosurface*, std::unique_ptr<IsosurfaceReach>> isosurfaces_;
};

/// Whether no point is in it.
bool isEmpty(const Bounds& bounds);

}  // namespace isoscope
