// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/solids/surface_of_revolution.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/roots/polynomial/real_roots.h"
#include "core/shapes/combined/turned_place.h"
#include "core/shapes/rays/hit_list.h"

namespace isoscope {

double SurfaceOfRevolution::Segment::square(double height) const {
    const double k = height - low;
    return c[0] + k * (c[1] + k * (c[2] + k * c[3]));
}

double SurfaceOfRevolution::Segment::slope(double height) const {
    const double k = height - low;
    return c[1] + k * (2 * c[2] + k * 3 * c[3]);
}

bool SurfaceOfRevolution::usable(std::span<const glm::dvec2> points) {
    if (points.size() < 4) return false;
    for (std::size_t i = 1; i + 2 < points.size(); ++i)
        if (!(points[i].y < points[i + 1].y)) return false;
    const std::size_t last = points.size() - 1;
    return points[0].y != points[2].y && points[last].y != points[last - 2].y;
}

SurfaceOfRevolution::SurfaceOfRevolution(std::span<const glm::dvec2> p, bool open) : open_(open) {
    for (std::size_t j = 1; j + 2 < p.size(); ++j) {
        const double height = p[j + 1].y - p[j].y;
        const double f0 = p[j].x * p[j].x, f1 = p[j + 1].x * p[j + 1].x;
        const double s0 = 2 * p[j].x * (p[j + 1].x - p[j - 1].x) / (p[j + 1].y - p[j - 1].y) * height;
        const double s1 = 2 * p[j + 1].x * (p[j + 2].x - p[j].x) / (p[j + 2].y - p[j].y) * height;
        const double square = 3 * (f1 - f0) - 2 * s0 - s1, cube = 2 * (f0 - f1) + s0 + s1;
        const Segment segment{
            p[j].y,
            p[j + 1].y,
            {f0, s0 / height, square / (height * height), cube / (height * height * height)}};
        segments_.push_back(segment);
        double largest = std::max(f0, f1);
        RootSequence turns;
        realRoots(std::array<double, 3>{3 * segment.c[3], 2 * segment.c[2], segment.c[1]}, 0, height, turns);
        for (const double k : turns) largest = std::max(largest, segment.square(segment.low + k));
        radius_ = std::max(radius_, std::sqrt(largest));
    }
}

void SurfaceOfRevolution::intersect(const Ray& ray, RayInterval interval, TraceContext& context,
                                    HitList& hits) const {
    ++context.rays;
    if (segments_.empty()) return;
    const CenteredRay line(ray, {0, (segments_.front().low + segments_.back().high) / 2, 0});
    if (!line.usable) return;
    const std::size_t first = hits.size();
    for (const Segment& segment : segments_) addSegment(segment, ray, line, interval, hits);
    if (!open_) {
        const Segment &bottom = segments_.front(), &top = segments_.back();
        addCap(bottom.low, bottom.square(bottom.low), -1, ray, interval, hits);
        addCap(top.high, top.square(top.high), 1, ray, interval, hits);
    }
    sortHits(hits, first);
}

void SurfaceOfRevolution::addSegment(const Segment& segment, const Ray& ray, const CenteredRay& line,
                                     RayInterval interval, HitList& hits) const {
    const double middle = (segments_.front().low + segments_.back().high) / 2;
    const glm::dvec3 &o = line.origin, &d = line.direction;
    // Height above the segment's low end: k = start + s climb.
    const double start = o.y + middle - segment.low, climb = d.y, height = segment.high - segment.low;
    const double reach = std::hypot(radius_, segments_.back().high - segments_.front().low) * 2;
    double low = -reach, high = reach;
    if (std::abs(climb) * reach < 1e-12 * height) {
        if (start < 0 || start > height) return;
    } else {
        const double one = -start / climb, other = (height - start) / climb;
        low = std::max(low, std::min(one, other));
        high = std::min(high, std::max(one, other));
    }
    if (!(low <= high)) return;
    const double* c = segment.c;
    const double value = c[0] + start * (c[1] + start * (c[2] + start * c[3]));
    const double slope = c[1] + start * (2 * c[2] + start * 3 * c[3]), bend = c[2] + 3 * start * c[3];
    const std::array<double, 4> cubic{
        -c[3] * climb * climb * climb, d.x * d.x + d.z * d.z - bend * climb * climb,
        2 * (o.x * d.x + o.z * d.z) - slope * climb, o.x * o.x + o.z * o.z - value};
    RootSequence roots;
    realRoots(cubic, low, high, roots);
    for (const double s : roots) {
        const double t = line.toRay(s);
        if (!(interval.near <= t && t <= interval.far)) continue;
        const glm::dvec3 at = line.at(s);
        const double rise = segment.slope(segment.low + start + s * climb);
        hits.push_back({t, ray.at(t), unitNormal({2 * at.x, -rise, 2 * at.z})});
    }
}

void SurfaceOfRevolution::addCap(double height, double square, double up, const Ray& ray,
                                 RayInterval interval, HitList& hits) const {
    if (ray.direction.y == 0 || !(square > 0)) return;
    const double t = (height - ray.origin.y) / ray.direction.y;
    if (!(interval.near <= t && t <= interval.far) || !std::isfinite(t)) return;
    const glm::dvec3 at = ray.at(t);
    if (at.x * at.x + at.z * at.z <= square) hits.push_back({t, at, {0, up, 0}});
}

bool SurfaceOfRevolution::contains(const glm::dvec3& point, TraceContext&) const {
    for (const Segment& segment : segments_)
        if (point.y >= segment.low && point.y <= segment.high)
            return point.x * point.x + point.z * point.z < segment.square(point.y);
    return false;
}

Bounds SurfaceOfRevolution::bounds() const {
    if (segments_.empty()) return {glm::dvec3(0), glm::dvec3(0)};
    return {{-radius_, segments_.front().low, -radius_}, {radius_, segments_.back().high, radius_}};
}

/// v follows the height, evenly in each segment; on the lids the radius, from the middle of the lower one to
/// that of the upper.
std::optional<glm::dvec2> SurfaceOfRevolution::surfacePlace(const glm::dvec3& point) const {
    const double u = turnedPlace(point.x, point.z), radius = std::hypot(point.x, point.z);
    const Segment &first = segments_.front(), &last = segments_.back();
    const double low = first.low, size = last.high - low, near = 1e-7 * size;
    const auto rimOf = [](double square) { return square > 0 ? std::sqrt(square) : 0; };
    const double lower = rimOf(first.square(low)), upper = rimOf(last.square(last.high));
    if (!open_ && std::abs(point.y - low) < near && radius < lower - near)
        return glm::dvec2(u, radius / lower);
    if (!open_ && std::abs(point.y - last.high) < near && radius < upper - near)
        return glm::dvec2(u, 1 - radius / upper);
    std::size_t k = 0;
    while (k + 1 < segments_.size() && point.y > segments_[k].high) ++k;
    const Segment& segment = segments_[k];
    const double length = segment.high - segment.low;
    const double along = length > 0 ? std::clamp((point.y - segment.low) / length, 0.0, 1.0) : 0;
    return glm::dvec2(u, (static_cast<double>(k) + along) / static_cast<double>(segments_.size()));
}

}  // namespace isoscope
