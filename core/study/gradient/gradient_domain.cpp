// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/gradient_domain.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace isoscope {

namespace {

/// Of direction . p over a box.
SlopeRange rangeAlong(const glm::dvec3& direction, const GradientBox& box) {
    SlopeRange range;
    for (int k = 0; k < 3; ++k) range = range + direction[k] * SlopeRange{box.low[k], box.high[k]};
    return range;
}

}  // namespace

double GradientBox::width() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }

std::array<Interval, 3> GradientBox::intervals() const {
    return {Interval{low.x, high.x, false}, Interval{low.y, high.y, false}, Interval{low.z, high.z, false}};
}

std::array<SlopeRange, 3> GradientBox::waysFrom(const glm::dvec3& p) const {
    return {SlopeRange{lowered(low.x - p.x), raised(high.x - p.x)},
            SlopeRange{lowered(low.y - p.y), raised(high.y - p.y)},
            SlopeRange{lowered(low.z - p.z), raised(high.z - p.z)}};
}

GradientDomain::GradientDomain(const Container& container) {
    if (const auto* box = std::get_if<ContainerBox>(&container)) {
        box_ = {glm::min(box->low, box->high), glm::max(box->low, box->high)};
    } else {
        const auto& sphere = std::get<ContainerSphere>(container);
        isBall_ = true;
        center_ = sphere.center;
        radius_ = std::abs(sphere.radius);
        const double reach = raised(radius_);
        for (int k = 0; k < 3; ++k) {
            box_.low[k] = lowered(center_[k] - reach);
            box_.high[k] = raised(center_[k] + reach);
        }
    }
    for (int k = 0; k < 3; ++k)
        empty_ = empty_ || !(std::abs(box_.low[k]) < 1e150) || !(std::abs(box_.high[k]) < 1e150);
}

GradientDomain::GradientDomain(const ContainerBox& box, std::vector<Strip> strips) : GradientDomain(box) {
    strips_ = std::move(strips);
}

GradientDomain GradientDomain::flattened(int axis) const {
    GradientDomain result = *this;
    result.box_.low[axis] = result.box_.high[axis] = box_.center()[axis];
    return result;
}

bool GradientDomain::contains(const glm::dvec3& p) const {
    for (int k = 0; k < 3; ++k)
        if (!(p[k] >= box_.low[k] && p[k] <= box_.high[k])) return false;
    for (const Strip& strip : strips_) {
        const SlopeRange at = rangeAlong(strip.direction, {p, p});
        if (at.low < strip.low || at.high > strip.high) return false;
    }
    if (!isBall_) return true;
    double distance = 0;
    for (int k = 0; k < 3; ++k) {
        const double way = raised(std::abs(p[k] - center_[k]));
        distance = raised(distance + raised(way * way));
    }
    return distance <= lowered(radius_ * radius_);
}

bool GradientDomain::misses(const GradientBox& box) const {
    for (const Strip& strip : strips_) {
        const SlopeRange across = rangeAlong(strip.direction, box);
        if (across.high < strip.low || across.low > strip.high) return true;
    }
    if (!isBall_) return false;
    double distance = 0;
    for (int k = 0; k < 3; ++k) {
        const double way =
            std::max({0.0, lowered(box.low[k] - center_[k]), lowered(center_[k] - box.high[k])});
        distance = lowered(distance + lowered(way * way));
    }
    return distance > raised(radius_ * radius_);
}

bool GradientDomain::encloses(const GradientBox& box) const {
    for (const Strip& strip : strips_) {
        const SlopeRange across = rangeAlong(strip.direction, box);
        if (across.low < strip.low || across.high > strip.high) return false;
    }
    if (!isBall_) return true;
    glm::dvec3 corner;
    for (int k = 0; k < 3; ++k)
        corner[k] = center_[k] - box.low[k] > box.high[k] - center_[k] ? box.low[k] : box.high[k];
    return contains(corner);
}

glm::dvec3 GradientDomain::nearest(const glm::dvec3& point) const {
    if (!isBall_) {
        constexpr int rounds = 16;  // which end once no wall is in the way
        glm::dvec3 place = glm::clamp(point, box_.low, box_.high);
        for (int round = 0; round < rounds && !strips_.empty(); ++round) {
            const glm::dvec3 last = place;
            for (const Strip& strip : strips_) {
                const double along = glm::dot(strip.direction, place);
                place += (std::clamp(along, strip.low, strip.high) - along) * strip.direction;
            }
            place = glm::clamp(place, box_.low, box_.high);
            if (place == last) break;
        }
        return place;
    }
    const glm::dvec3 way = point - center_;
    const double distance = glm::length(way), reach = radius_ * (1 - 1e-15);
    return distance <= reach ? point : center_ + way * (reach / distance);
}

double GradientDomain::advance(const std::array<SlopeRange, 3>& direction, const GradientBox& box,
                               const glm::dvec3& from) const {
    const std::array<SlopeRange, 3> ways = box.waysFrom(from);
    double throughBox = 0;
    for (std::size_t k = 0; k < 3; ++k) throughBox = raised(throughBox + (direction[k] * ways[k]).high);
    if (!isBall_) return throughBox;
    // The middle of the directions meets the ball; what is left of them meets the box.
    std::array<SlopeRange, 3> middle;
    double rest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double m = 0.5 * direction[k].low + 0.5 * direction[k].high;
        middle[k] = {m, m};
        const double off = raised(std::max(raised(direction[k].high - m), raised(m - direction[k].low)));
        rest = raised(rest + raised(off * ways[k].size()));
    }
    const std::array<SlopeRange, 3> toMiddle = GradientBox{center_, center_}.waysFrom(from);
    double length = 0, toCenter = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        length = raised(length + square(middle[k]).high);
        toCenter = raised(toCenter + (middle[k] * toMiddle[k]).high);
    }
    const double throughBall = raised(raised(raised(rootAbove(length) * raised(radius_)) + toCenter) + rest);
    return std::min(throughBox, throughBall);
}

}  // namespace isoscope
