// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/rays/placed_lanes.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/shapes/rays/placed_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>

#include "core/shapes/patches/unit_normal-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

void moveColumns(const glm::dmat4& matrix, const RayBatch& rays, RayBatch& to) {
    const Doubles d;
    const auto origins = rays.origins(), directions = rays.directions();
    for (int c = 0; c < 3; ++c) {
        const auto axis = static_cast<std::size_t>(c);
        const Vector x = constant(matrix[0][c]), y = constant(matrix[1][c]), z = constant(matrix[2][c]),
                     shift = constant(matrix[3][c]);
        double* const origin = to[static_cast<RayBatch::Column>(RayBatch::originX + axis)];
        double* const direction = to[static_cast<RayBatch::Column>(RayBatch::directionX + axis)];
        for (std::size_t k = 0; k < rays.size(); k += hn::Lanes(d)) {
            const Triple p = load(origins, k), v = load(directions, k);
            const Vector moved =
                hn::Add(hn::Add(hn::Mul(x, p.x), hn::Mul(y, p.y)), hn::Add(hn::Mul(z, p.z), shift));
            const Vector turned = hn::Add(hn::Add(hn::Mul(x, v.x), hn::Mul(y, v.y)), hn::Mul(z, v.z));
            hn::StoreU(moved, d, origin + k);
            hn::StoreU(turned, d, direction + k);
        }
    }
}

void turnColumns(const glm::dmat4& matrix, const double* before, std::size_t count, HitBatch::Columns hits) {
    const Doubles d;
    Triple rows[3];
    for (int c = 0; c < 3; ++c) rows[c] = constant(glm::dvec3(matrix[c]));
    for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
        const auto present = hn::FirstN(d, std::min(count - k, hn::Lanes(d)));
        const auto found = hn::And(present, hn::Lt(hn::LoadU(d, hits.t + k), hn::LoadU(d, before + k)));
        if (hn::AllFalse(d, found)) continue;
        const Triple normal = load(hits.normal, k);
        const Triple turned{dot(rows[0], normal), dot(rows[1], normal), dot(rows[2], normal)};
        store(choose(found, unitNormals(turned, found), normal), hits.normal, k);
    }
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(moveColumns);
HWY_EXPORT(turnColumns);

void moveToObject(const Transform& transform, const RayBatch& rays, RayBatch& to) {
    to.reserve(rays.size());
    to.setSize(rays.size());
    HWY_DYNAMIC_DISPATCH(moveColumns)(transform.backward(), rays, to);
    std::copy_n(rays.samples(), rays.size(), to.samples());
}

void turnNormals(const Transform& transform, const double* before, HitBatch& hits) {
    HWY_DYNAMIC_DISPATCH(turnColumns)(transform.backward(), before, hits.size(), hits.columns());
}

}  // namespace isoscope
#endif
