// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/isosurface_reach.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "core/numeric/slope_range.h"

namespace isoscope {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// As many as are evaluated at once, each into eight.
constexpr std::size_t dividedAtOnce = batchLanes / 8;

}  // namespace

IsosurfaceReach::IsosurfaceReach(std::shared_ptr<const Isosurface> surface,
                                 std::span<const double> parameters, ReachSettings settings)
    : surface_(std::move(surface)),
      settings_(settings),
      domain_(surface_->settings().container),
      intervals_(surface_->prepared(parameters)) {}

double IsosurfaceReach::along(const glm::dvec3& direction, std::stop_token stop) {
    if (domain_.empty()) return -infinity;
    direction_ = direction;
    center_.reset();
    return search(glm::dot(glm::abs(direction), domain_.box().high - domain_.box().low), stop);
}

double IsosurfaceReach::around(const glm::dvec3& center, std::stop_token stop) {
    if (domain_.empty()) return -infinity;
    center_ = center;
    return search(glm::length(domain_.box().high - domain_.box().low), stop);
}

/// `span`: how far the reaches of two points of the domain may be apart.
double IsosurfaceReach::search(double span, std::stop_token stop) {
    queue_ = {};
    const Room whole{domain_.box(), reachOf(domain_.box()), 0};
    keep({&whole, 1});
    const auto fine = [&](const Room& room) {
        return span * std::ldexp(1.0, -room.depth) <= settings_.tolerance * span;
    };
    const std::uint64_t limit = boxes() + settings_.boxLimit;
    std::vector<Room> parts;
    while (!queue_.empty() && !fine(queue_.top()) && boxes() < limit && !stop.stop_requested()) {
        parts.clear();
        for (std::size_t i = 0; i < dividedAtOnce && !queue_.empty() && !fine(queue_.top()); ++i) {
            divide(queue_.top(), parts);
            queue_.pop();
        }
        keep(parts);
    }
    return queue_.empty() ? -infinity : queue_.top().reach;
}

double IsosurfaceReach::reachOf(const GradientBox& box) const {
    if (center_) return distanceOf(box);
    double reach = 0;
    for (int k = 0; k < 3; ++k)
        reach = raised(reach + raised(direction_[k] * (direction_[k] < 0 ? box.low[k] : box.high[k])));
    if (!domain_.isBall()) return reach;
    const double ball =
        glm::dot(direction_, domain_.ballCenter()) + glm::length(direction_) * domain_.radius() * (1 + 1e-12);
    return std::min(reach, ball);
}

double IsosurfaceReach::distanceOf(const GradientBox& box) const {
    const glm::dvec3 farthest = glm::max(glm::abs(box.low - *center_), glm::abs(box.high - *center_));
    const double corner = glm::length(farthest) * (1 + 1e-12);
    if (!domain_.isBall()) return corner;
    const double ball = glm::distance(*center_, domain_.ballCenter()) + domain_.radius();
    return std::min(corner, ball * (1 + 1e-12));
}

void IsosurfaceReach::divide(const Room& room, std::vector<Room>& parts) const {
    const glm::dvec3 middle = room.box.center();
    for (int corner = 0; corner < 8; ++corner) {
        GradientBox part = room.box;
        for (int k = 0; k < 3; ++k) (corner >> k & 1 ? part.low : part.high)[k] = middle[k];
        if (!domain_.misses(part)) parts.push_back({part, reachOf(part), room.depth + 1});
    }
}

void IsosurfaceReach::keep(std::span<const Room> rooms) {
    BoxLanes lanes{};
    for (std::size_t i = 0; i < rooms.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            lanes.low[k][i] = rooms[i].box.low[static_cast<int>(k)];
            lanes.high[k][i] = rooms[i].box.high[static_cast<int>(k)];
        }
    std::array<Interval, batchLanes> values;
    intervals_.evaluate(lanes, std::span(values).first(rooms.size()));
    for (std::size_t i = 0; i < rooms.size(); ++i)
        if (mayShow(rooms[i].box, values[i])) queue_.push(rooms[i]);
}

bool IsosurfaceReach::mayShow(const GradientBox& box, const Interval& values) const {
    const IsosurfaceSettings& settings = surface_->settings();
    const double threshold = settings.threshold;
    if (values.low <= threshold && values.high >= threshold) return true;
    if (settings.open || !touchesWall(box)) return false;
    // Of a wall shows what is inside; what is not defined counts as that.
    const bool inside = settings.positivePolarity ? values.high > threshold : values.low < threshold;
    return values.maybeUndefined || (!values.empty() && inside);
}

bool IsosurfaceReach::touchesWall(const GradientBox& box) const {
    if (domain_.isBall()) return !domain_.encloses(box);
    for (int k = 0; k < 3; ++k)
        if (box.low[k] <= domain_.box().low[k] || box.high[k] >= domain_.box().high[k]) return true;
    return false;
}

}  // namespace isoscope
