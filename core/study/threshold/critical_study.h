// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/evaluate/interval_gradient_evaluator.h"
#include "core/evaluate/point_evaluator.h"
#include "core/study/gradient/gradient_domain.h"
#include "core/study/threshold/critical_point.h"
#include "core/study/threshold/newton_test.h"

namespace isoscope {

/// When a CriticalStudy ends, at the latest.
struct CriticalStudySettings {
    std::uint64_t boxLimit = 400'000;  ///< evaluations over boxes; bounds the memory, too
    std::size_t pointLimit = 4'000;    ///< proven points
};

/// Finds the critical points of a function inside the container of an isosurface: the points where its
/// gradient is 0. They are where pieces of the surface appear, join, and get tunnels while the threshold
/// changes. Boxes are halved, the largest first; those without such a point are dismissed by interval
/// differentiation, and interval Newton steps prove single ones. What can be neither is told as suspected.
/// The container's wall, at which pieces may appear and join as well, is not looked at.
///
/// What is proven holds for the function as IntervalGradientEvaluator understands it. Not for several threads
/// at once.
class CriticalStudy {
  public:
    /// A container that is not finite has no points.
    CriticalStudy(const std::shared_ptr<const PreparedFunction>& function, const Container& container,
                  CriticalStudySettings settings = {});

    /// Works on about `boxes` further boxes; a stop ends it with the box at hand, and the next call goes on.
    /// Returns whether there is more to do.
    bool step(std::uint64_t boxes, std::stop_token stop = {});
    /// Works to the end or to a stop; `progress` (which may be empty) is told several times a second how much
    /// of the work is done at least, from 0 to 1. After a stop nothing is told.
    CriticalPoints run(const std::function<void(double)>& progress = {}, std::stop_token stop = {});

    /// How much of what may be spent is spent, from 0 to 1; 1 when nothing is left to do.
    double progress() const;
    /// What is known now. What is suspected is told with a value and a kind, for which the function is looked
    /// at a thousand times each; after a stop with neither.
    CriticalPoints points(std::stop_token stop = {});

  private:
    struct Known {
        CriticalPoint point;
        GradientBox alone;  ///< there is no other one in it
        bool outside = false;
    };
    struct Region {
        GradientBox box;
        Interval values;  ///< of a larger one around it
    };
    /// What is done with, and holds what is suspected.
    struct Left {
        Region region;
        SuspicionReason reason;
    };

    void consider(const Region& region);
    GradientBox widened(const GradientBox& box) const;
    bool settledByNewton(GradientBox& box, const IntervalGradient& whole);
    void add(const GradientBox& alone, const GradientBox& rest);
    bool isKnown(const GradientBox& box) const;
    void halve(const Region& region, std::deque<Region>& queue);
    bool nothingLeft() const { return queues_[0].empty() && queues_[1].empty(); }
    CriticalPoint suspected(std::span<const Left> places, const std::stop_token& stop);
    CriticalKind guess(const CriticalPoint& point, double reach, const std::stop_token& stop);
    double highestAround(const glm::dvec3& center, double radius, double sign, const std::stop_token& stop);
    double volumeShare(const GradientBox& box) const;

    GradientDomain domain_;
    CriticalStudySettings settings_;
    IntervalGradientEvaluator intervals_;
    PointEvaluator values_;
    NewtonTest newton_;
    std::array<std::deque<Region>, 2> queues_;  ///< without and with second derivatives
    std::size_t turn_ = 0;                      ///< which one comes next
    std::vector<Known> known_;
    std::vector<Left> left_;
    double share_ = 1;
    bool jumps_ = false;
};

/// Boxes in groups that touch or nearly touch each other, each in order of their numbers. "Nearly" is a cell
/// of `domain` in parts of 1/128.
std::vector<std::vector<std::size_t>> touchingBoxes(const GradientBox& domain,
                                                    std::span<const GradientBox> boxes);

}  // namespace isoscope
