// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/light/light_aim.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/light/light_aim.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/shapes/patches/vector_triple-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

void aimAtAll(const glm::dvec3& location, SurfacePoints& points) {
    const Triple source = constant(location);
    for (std::size_t k = 0; k < points.size(); k += hn::Lanes(Doubles())) {
        const Triple arm = minus(source, load(points.point, k));
        const Vector distance = hn::Sqrt(dot(arm, arm));
        hn::StoreU(distance, Doubles(), &points.distance[k]);
        hn::StoreU(constant(1), Doubles(), &points.strength[k]);
        const auto apart = hn::Gt(distance, hn::Zero(Doubles()));
        const Triple unit = times(arm, hn::Div(constant(1), distance));
        for (std::size_t c = 0; c < 3; ++c)
            hn::StoreU(hn::IfThenElseZero(apart, unit[c]), Doubles(), &points.toLight[c][k]);
    }
}

void aimAlongAll(const glm::dvec3& direction, const glm::dvec3& location, SurfacePoints& points) {
    const Triple source = constant(location), from = constant(direction);
    for (std::size_t k = 0; k < points.size(); k += hn::Lanes(Doubles())) {
        const Triple arm = minus(source, load(points.point, k));
        hn::StoreU(dot(arm, from), Doubles(), &points.distance[k]);
        hn::StoreU(constant(1), Doubles(), &points.strength[k]);
        store(from, points.toLight, k);
    }
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(aimAtAll);
HWY_EXPORT(aimAlongAll);

void aimAt(const glm::dvec3& location, SurfacePoints& points) {
    HWY_DYNAMIC_DISPATCH(aimAtAll)(location, points);
}

void aimAlong(const glm::dvec3& direction, const glm::dvec3& location, SurfacePoints& points) {
    HWY_DYNAMIC_DISPATCH(aimAlongAll)(direction, location, points);
}

}  // namespace isoscope
#endif
