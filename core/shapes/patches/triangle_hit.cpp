// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/patches/triangle_hit.h"

#include <cmath>
#include <utility>

namespace isoscope {

TriangleLine::TriangleLine(const Ray& ray) : origin_(ray.origin) {
    const glm::dvec3& d = ray.direction;
    const double ax = std::abs(d.x), ay = std::abs(d.y), az = std::abs(d.z);
    z_ = ax > ay ? (ax > az ? 0 : 2) : (ay > az ? 1 : 2);
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    if (d[z_] < 0) std::swap(x_, y_);
    shearX_ = d[x_] / d[z_];
    shearY_ = d[y_] / d[z_];
    scale_ = 1 / d[z_];
    usable_ = std::isfinite(shearX_) && std::isfinite(shearY_) && std::isfinite(scale_);
}

std::optional<TriangleHit> TriangleLine::meet(const glm::dvec3& a, const glm::dvec3& b,
                                              const glm::dvec3& c) const {
    if (!usable_) return std::nullopt;
    const glm::dvec3 fromA = a - origin_, fromB = b - origin_, fromC = c - origin_;
    const double ax = fromA[x_] - shearX_ * fromA[z_], ay = fromA[y_] - shearY_ * fromA[z_];
    const double bx = fromB[x_] - shearX_ * fromB[z_], by = fromB[y_] - shearY_ * fromB[z_];
    const double cx = fromC[x_] - shearX_ * fromC[z_], cy = fromC[y_] - shearY_ * fromC[z_];
    const double u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
    const double sum = u + v + w;
    if (sum == 0 || !std::isfinite(sum)) return std::nullopt;
    const glm::dvec3 shares(u / sum, v / sum, w / sum);
    const double t = scale_ * (shares.x * fromA[z_] + shares.y * fromB[z_] + shares.z * fromC[z_]);
    if (!std::isfinite(t)) return std::nullopt;
    return TriangleHit{t, shares};
}

}  // namespace isoscope
