// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/container.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/shapes/container.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>

#include "core/shapes/line_interval.h"
#include "core/shapes/vector_triple-inl.h"

#ifndef ISOSCOPE_SHAPES_CONTAINER_ONCE
#define ISOSCOPE_SHAPES_CONTAINER_ONCE
namespace isoscope {

/// Some lines coordinate by coordinate, and where they pass: room for whole vectors.
struct PassageBlock {
    static constexpr std::size_t lines = 64;
    using Lines = std::array<double, lines>;

    std::array<Lines, 3> origin, direction;
    Lines near, far, nearAxis, farAxis;
};

}  // namespace isoscope
#endif

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

using Mask = hn::Mask<Doubles>;

/// An empty interval where the line does not pass.
HWY_INLINE void storeRange(Mask passes, Vector near, Vector far, PassageBlock& block, std::size_t k) {
    hn::StoreU(hn::IfThenElse(passes, near, constant(1)), Doubles(), &block.near[k]);
    hn::StoreU(hn::IfThenElseZero(passes, far), Doubles(), &block.far[k]);
}

/// As sphereRange().
void passSphere(const ContainerSphere& sphere, std::size_t count, PassageBlock& block) {
    const Triple center = constant(sphere.center);
    const Vector squaredRadius = constant(sphere.radius * sphere.radius), zero = hn::Zero(Doubles());
    for (std::size_t k = 0; k < count; k += hn::Lanes(Doubles())) {
        const Triple direction = load(block.direction, k);
        const Vector squaredSpeed = dot(direction, direction);
        const Triple arm = minus(load(block.origin, k), center);
        const Vector middle = hn::Div(hn::Neg(dot(arm, direction)), squaredSpeed);
        const Triple across = plus(arm, times(direction, middle));
        const Vector squaredChord = hn::Div(hn::Sub(squaredRadius, dot(across, across)), squaredSpeed);
        const Vector half = hn::Sqrt(squaredChord);
        const Mask meets = hn::And(hn::Gt(squaredSpeed, zero), hn::Gt(squaredChord, zero));
        const Mask passes = hn::And(meets, hn::And(finite(middle), finite(half)));
        storeRange(passes, hn::Sub(middle, half), hn::Add(middle, half), block, k);
    }
}

/// As boxRange().
void passBox(const ContainerBox& box, std::size_t count, PassageBlock& block) {
    const Triple low = constant(box.low), high = constant(box.high);
    const Vector zero = hn::Zero(Doubles()), infinity = constant(std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < count; k += hn::Lanes(Doubles())) {
        const Triple origins = load(block.origin, k), directions = load(block.direction, k);
        Vector near = hn::Neg(infinity), far = infinity, nearAxis = zero, farAxis = zero;
        Mask passes = hn::Eq(zero, zero);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Vector origin = origins[axis], direction = directions[axis];
            const Vector below = hn::Sub(low[axis], origin), above = hn::Sub(high[axis], origin);
            const Mask across = hn::Ne(direction, zero), forwards = hn::Gt(direction, zero);
            const Mask between = hn::And(hn::Le(below, zero), hn::Ge(above, zero));
            passes = hn::And(passes, hn::And(finite(origin), finite(direction)));
            passes = hn::And(passes, hn::And(hn::Le(low[axis], high[axis]), hn::Or(across, between)));
            const Vector first = hn::Div(hn::IfThenElse(forwards, below, above), direction);
            const Vector last = hn::Div(hn::IfThenElse(forwards, above, below), direction);
            const Mask later = hn::And(across, hn::Gt(first, near));
            const Mask sooner = hn::And(across, hn::Lt(last, far));
            near = hn::IfThenElse(later, first, near);
            far = hn::IfThenElse(sooner, last, far);
            nearAxis = hn::IfThenElse(later, constant(static_cast<double>(axis)), nearAxis);
            farAxis = hn::IfThenElse(sooner, constant(static_cast<double>(axis)), farAxis);
        }
        storeRange(hn::And(passes, hn::And(finite(near), finite(far))), near, far, block, k);
        hn::StoreU(nearAxis, Doubles(), &block.nearAxis[k]);
        hn::StoreU(farAxis, Doubles(), &block.farAxis[k]);
    }
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(passSphere);
HWY_EXPORT(passBox);

void ContainerPassages::find(const Container& container, std::span<const Ray> rays) {
    for (std::vector<double>* list : {&near_, &far_, &nearAxis_, &farAxis_}) list->resize(rays.size());
    const auto* box = std::get_if<ContainerBox>(&container);
    PassageBlock block{};
    for (std::size_t first = 0; first < rays.size(); first += PassageBlock::lines) {
        const std::size_t count = std::min(PassageBlock::lines, rays.size() - first);
        for (std::size_t k = 0; k < count; ++k) {
            const Ray& ray = rays[first + k];
            block.origin[0][k] = ray.origin.x, block.direction[0][k] = ray.direction.x;
            block.origin[1][k] = ray.origin.y, block.direction[1][k] = ray.direction.y;
            block.origin[2][k] = ray.origin.z, block.direction[2][k] = ray.direction.z;
        }
        if (box)
            HWY_DYNAMIC_DISPATCH(passBox)(*box, count, block);
        else
            HWY_DYNAMIC_DISPATCH(passSphere)(std::get<ContainerSphere>(container), count, block);
        std::copy_n(block.near.begin(), count, &near_[first]);
        std::copy_n(block.far.begin(), count, &far_[first]);
        if (!box) continue;
        std::copy_n(block.nearAxis.begin(), count, &nearAxis_[first]);
        std::copy_n(block.farAxis.begin(), count, &farAxis_[first]);
    }
}

glm::dvec3 ContainerPassages::wallNormal(const Container& container, const Ray& ray, std::size_t i,
                                         bool entering) const {
    if (const auto* sphere = std::get_if<ContainerSphere>(&container)) {
        const LineInterval inside = sphereInterval(ray, sphere->center, sphere->radius);
        return entering ? inside.nearNormal : inside.farNormal;
    }
    const int axis = static_cast<int>(entering ? nearAxis_[i] : farAxis_[i]);
    glm::dvec3 normal(0);
    normal[axis] = (ray.direction[axis] > 0) == entering ? -1 : 1;
    return normal;
}

}  // namespace isoscope
#endif
