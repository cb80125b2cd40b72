// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/isosurface/povray_parametric.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/shapes/rays/hit_list.h"

namespace isoscope {

PovrayParametric::PovrayParametric(const std::array<std::shared_ptr<const Tape>, 3>& tapes,
                                   std::span<const double> parameters, const ParametricSettings& settings)
    : settings_(settings) {
    for (const auto& tape : tapes) coordinates_.emplace_back(tape, parameters);
}

template <std::size_t count>
std::array<glm::dvec3, count> PovrayParametric::points(const std::array<glm::dvec2, count>& places) {
    std::array<double, count> u, v, out;
    const std::array<double, count> zero{};
    for (std::size_t k = 0; k < count; ++k) {
        u[k] = places[k].x;
        v[k] = places[k].y;
    }
    std::array<glm::dvec3, count> result;
    for (int axis = 0; axis < 3; ++axis) {
        coordinates_[static_cast<std::size_t>(axis)].evaluate(u, v, zero, out);
        for (std::size_t k = 0; k < count; ++k) result[k][axis] = out[k];
    }
    evaluations_ += count;
    return result;
}

std::optional<Hit> PovrayParametric::nearest(const Ray& ray, RayInterval interval,
                                             const std::stop_token& stop) {
    ray_ = ray;
    interval_ = interval;
    stop_ = stop;
    best_ = interval.far;
    nearest_ = interval.near + 4 * settings_.accuracy / glm::length(ray.direction);
    found_.reset();
    rectangles_ = 0;
    const Rectangle whole{settings_.low, settings_.high};
    const Entry entry = enter(whole, points<1>({whole.middle()})[0]);
    if (entry.meets) visit(whole, entry);
    if (!found_ || rectangles_ > rectangleLimit) return std::nullopt;
    const glm::dvec2 corner = found_->low;
    const double side = settings_.accuracy;
    const auto p = points<3>({corner, corner + glm::dvec2(side, 0), corner + glm::dvec2(0, side)});
    return Hit{best_, ray.at(best_), unitNormal(glm::cross(p[1] - p[0], p[2] - p[0]))};
}

std::array<glm::dvec3, 2> PovrayParametric::middlesOf(std::uint32_t number,
                                                      const std::array<Rectangle, 2>& halves) {
    const auto evaluated = [&] { return points<2>({halves[0].middle(), halves[1].middle()}); };
    if (number == 0 || number >= keptLimit) return evaluated();
    const glm::dvec3 unknown(std::numeric_limits<double>::quiet_NaN());
    if (kept_.empty()) kept_.assign(keptLimit, {unknown, unknown});
    std::array<glm::dvec3, 2>& kept = kept_[number];
    if (std::isnan(kept[0].x)) kept = evaluated();
    return kept;
}

PovrayParametric::Entry PovrayParametric::enter(const Rectangle& rectangle, const glm::dvec3& middle) const {
    const glm::dvec2 sides = rectangle.high - rectangle.low;
    const double reach = settings_.maxGradient * (sides.x + sides.y) / 2;
    Entry entry{false, interval_.near, interval_.near};
    double far = interval_.far;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = middle[axis] - reach - settings_.accuracy - ray_.origin[axis],
                     high = middle[axis] + reach - settings_.accuracy - ray_.origin[axis];
        const double slope = ray_.direction[axis];
        if (slope == 0) {
            if (!(low <= 0 && high >= 0)) return entry;
            continue;
        }
        entry.slabNear = (slope > 0 ? low : high) / slope;
        entry.near = std::max(entry.near, entry.slabNear);
        far = std::min(far, (slope > 0 ? high : low) / slope);
    }
    entry.meets = entry.near <= far;
    return entry;
}

void PovrayParametric::visit(const Rectangle& rectangle, const Entry& entry) {
    if (++rectangles_ > rectangleLimit || stop_.stop_requested() || !(entry.near < best_)) return;
    const glm::dvec2 sides = rectangle.high - rectangle.low;
    if (sides.x < settings_.accuracy && sides.y < settings_.accuracy) {
        if (!(entry.slabNear > nearest_)) return;
        best_ = entry.slabNear;
        found_ = rectangle;
        return;
    }
    const int axis = sides.x >= sides.y ? 0 : 1;
    std::array<Rectangle, 2> halves{rectangle, rectangle};
    const double cut = rectangle.middle()[axis];
    if (!(cut > rectangle.low[axis] && cut < rectangle.high[axis])) return;
    halves[0].high[axis] = halves[1].low[axis] = cut;
    for (std::uint32_t k = 0; k < 2; ++k)
        halves[k].number =
            rectangle.number < keptLimit ? 2 * rectangle.number + (rectangle.number ? k : 0) : 0;
    const std::array<glm::dvec3, 2> middle = middlesOf(rectangle.number, halves);
    for (std::size_t k = 0; k < 2; ++k)
        if (const Entry half = enter(halves[k], middle[k]); half.meets) visit(halves[k], half);
}

}  // namespace isoscope
