// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <queue>
#include <span>
#include <stop_token>
#include <vector>

#include "core/evaluate/box_evaluator.h"
#include "core/shapes/isosurface/isosurface.h"
#include "core/study/gradient/gradient_domain.h"

namespace isoscope {

/// How tightly the reach is proven; it is true with any settings.
struct ReachSettings {
    double tolerance = 0.003;       ///< of the container's own reach: boxes are not halved any further
    std::uint64_t boxLimit = 6000;  ///< of one direction; the answer is then less tight, but right
};

/// How far an isosurface reaches in a direction, or from a point, proven: boxes of the container in which the
/// function's enclosure keeps away from the threshold hold none of it, and the others are halved, farthest
/// first. What the container cuts counts where POV-Ray closes it. Not for several threads at once.
class IsosurfaceReach {
  public:
    IsosurfaceReach(std::shared_ptr<const Isosurface> surface, std::span<const double> parameters,
                    ReachSettings settings = {});

    /// No point p of the surface, in its own coordinates, has a larger direction . p; -infinity when there is
    /// no surface. A stop gives a number that is as true, and larger.
    double along(const glm::dvec3& direction, std::stop_token stop = {});
    /// No point of the surface is farther from `center`; -infinity when there is no surface.
    double around(const glm::dvec3& center, std::stop_token stop = {});

    /// Boxes looked at so far.
    std::uint64_t boxes() const { return intervals_.evaluations(); }

  private:
    struct Room {
        GradientBox box;
        double reach = 0;  ///< no point of the box goes farther
        int depth = 0;

        /// The farthest first, of those the smallest.
        bool operator<(const Room& other) const {
            return reach != other.reach ? reach < other.reach : depth < other.depth;
        }
    };

    double search(double span, std::stop_token stop);
    double reachOf(const GradientBox& box) const;
    double distanceOf(const GradientBox& box) const;
    void divide(const Room& room, std::vector<Room>& parts) const;
    /// Puts those of the boxes into the queue that may hold some of the surface.
    void keep(std::span<const Room> rooms);
    bool mayShow(const GradientBox& box, const Interval& values) const;
    bool touchesWall(const GradientBox& box) const;

    std::shared_ptr<const Isosurface> surface_;
    ReachSettings settings_;
    GradientDomain domain_;
    BoxEvaluator intervals_;
    glm::dvec3 direction_{0};
    std::optional<glm::dvec3> center_;  ///< instead of a direction
    std::priority_queue<Room> queue_;
};

}  // namespace isoscope
