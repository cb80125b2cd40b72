// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/rays/container.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/shapes/rays/container.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>

#include "core/shapes/patches/vector_triple-inl.h"
#include "core/shapes/rays/line_interval.h"

#ifndef ISOSCOPE_SHAPES_CONTAINER_ONCE
#define ISOSCOPE_SHAPES_CONTAINER_ONCE
namespace isoscope {

/// Lines coordinate by coordinate, and where they pass: room for whole vectors.
struct PassageColumns {
    std::array<const double*, 3> origin, direction;
    double *near, *far, *nearAxis, *farAxis;
};

}  // namespace isoscope
#endif

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

using Mask = hn::Mask<Doubles>;

/// An empty interval where the line does not pass.
HWY_INLINE void storeRange(Mask passes, Vector near, Vector far, const PassageColumns& block, std::size_t k) {
    hn::StoreU(hn::IfThenElse(passes, near, constant(1)), Doubles(), &block.near[k]);
    hn::StoreU(hn::IfThenElseZero(passes, far), Doubles(), &block.far[k]);
}

/// As sphereRange().
void passSphere(const ContainerSphere& sphere, std::size_t count, const PassageColumns& block) {
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

/// As sphereNormal() for `count` rays of a batch that meet a sphere of a usual size.
void turnFromSphere(const ContainerSphere& sphere, const RayBatch& rays, const std::size_t* lines,
                    std::size_t count, bool entering, const std::array<double*, 3>& normals) {
    const Triple center = constant(sphere.center);
    const Vector squaredRadius = constant(sphere.radius * sphere.radius);
    HWY_ALIGN double lanes[6][hn::MaxLanes(Doubles())] = {};
    for (std::size_t first = 0; first < count; first += hn::Lanes(Doubles())) {
        const std::size_t here = std::min(hn::Lanes(Doubles()), count - first);
        for (std::size_t c = 0; c < 6; ++c) {
            const double* const column = rays[static_cast<RayBatch::Column>(c)];
            for (std::size_t k = 0; k < here; ++k) lanes[c][k] = column[lines[first + k]];
        }
        const auto at = [&](std::size_t c) HWY_ATTR { return hn::Load(Doubles(), lanes[c]); };
        const Triple arm = minus({at(0), at(1), at(2)}, center), direction{at(3), at(4), at(5)};
        const Vector squaredSpeed = dot(direction, direction);
        const Vector middle = hn::Div(hn::Neg(dot(arm, direction)), squaredSpeed);
        const Triple across = plus(arm, times(direction, middle));
        const Vector half = hn::Sqrt(hn::Div(hn::Sub(squaredRadius, dot(across, across)), squaredSpeed));
        const Triple along = times(direction, half);
        const Triple outward = entering ? minus(across, along) : plus(across, along);
        const Vector length = hn::Sqrt(dot(outward, outward));
        for (std::size_t c = 0; c < 3; ++c)
            hn::StoreU(hn::Div(outward[c], length), Doubles(), normals[c] + first);
    }
}

/// As boxRange().
void passBox(const ContainerBox& box, std::size_t count, const PassageColumns& block) {
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

void cutAll(std::size_t count, const double* ends, double* near, double* far) {
    for (std::size_t k = 0; k < count; k += hn::Lanes(Doubles())) {
        const Vector begin = hn::Max(hn::LoadU(Doubles(), near + k), hn::Zero(Doubles()));
        const Mask passed = hn::Lt(hn::LoadU(Doubles(), ends + k), begin);
        hn::StoreU(begin, Doubles(), near + k);
        hn::StoreU(hn::IfThenElse(passed, constant(-1), hn::LoadU(Doubles(), far + k)), Doubles(), far + k);
    }
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(passSphere);
HWY_EXPORT(passBox);
HWY_EXPORT(cutAll);
HWY_EXPORT(turnFromSphere);

namespace {

void pass(const Container& container, std::size_t count, const PassageColumns& columns) {
    if (const auto* box = std::get_if<ContainerBox>(&container))
        HWY_DYNAMIC_DISPATCH(passBox)(*box, count, columns);
    else
        HWY_DYNAMIC_DISPATCH(passSphere)(std::get<ContainerSphere>(container), count, columns);
}

/// Of a box, where a line passes through a face.
glm::dvec3 faceNormal(int axis, double direction, bool entering) {
    glm::dvec3 normal(0);
    normal[axis] = (direction > 0) == entering ? -1 : 1;
    return normal;
}

}  // namespace

void ContainerPassages::makeRoom(const Container& container, std::size_t rays) {
    const std::size_t room = rays + LineColumns::padding;
    const auto lengthen = [&](AlignedColumn& list) {
        if (list.size() < room) list.resize(room);
    };
    lengthen(near_);
    lengthen(far_);
    if (!std::holds_alternative<ContainerBox>(container)) return;
    lengthen(nearAxis_);
    lengthen(farAxis_);
}

void ContainerPassages::find(const Container& container, std::span<const Ray> rays) {
    constexpr std::size_t few = LineColumns::padding;
    makeRoom(container, rays.size());
    std::array<std::array<double, few>, 6> block{};
    const auto at = [&](std::size_t column) -> const double* { return block[column].data(); };
    // Of a sphere there are no columns of axes.
    const bool faces = std::holds_alternative<ContainerBox>(container);
    const auto axes = [&](AlignedColumn& list, std::size_t first) {
        return faces ? list.data() + first : nullptr;
    };
    for (std::size_t first = 0; first < rays.size(); first += few) {
        const std::size_t count = std::min(few, rays.size() - first);
        for (std::size_t k = 0; k < count; ++k)
            for (int c = 0; c < 3; ++c) {
                block[static_cast<std::size_t>(c)][k] = rays[first + k].origin[c];
                block[static_cast<std::size_t>(c) + 3][k] = rays[first + k].direction[c];
            }
        pass(container, count,
             {{at(0), at(1), at(2)},
              {at(3), at(4), at(5)},
              &near_[first],
              &far_[first],
              axes(nearAxis_, first),
              axes(farAxis_, first)});
    }
}

void ContainerPassages::find(const Container& container, const RayBatch& rays) {
    makeRoom(container, rays.size());
    pass(container, rays.size(),
         {rays.origins(), rays.directions(), near_.data(), far_.data(), nearAxis_.data(), farAxis_.data()});
}

void ContainerPassages::beginWithRays(std::size_t rays, const double* ends) {
    HWY_DYNAMIC_DISPATCH(cutAll)(rays, ends, near_.data(), far_.data());
}

glm::dvec3 ContainerPassages::wallNormal(const Container& container, const Ray& ray, std::size_t i,
                                         bool entering) const {
    if (const auto* sphere = std::get_if<ContainerSphere>(&container))
        return sphereNormal(ray, sphere->center, sphere->radius, entering);
    return faceNormal(wallAxis(i, entering), ray.direction[wallAxis(i, entering)], entering);
}

glm::dvec3 ContainerPassages::wallNormal(const Container& container, const RayBatch& rays, std::size_t i,
                                         bool entering) const {
    if (!std::holds_alternative<ContainerBox>(container))
        return wallNormal(container, rays.ray(i), i, entering);
    const int axis = wallAxis(i, entering);
    return faceNormal(axis, rays.directions()[static_cast<std::size_t>(axis)][i], entering);
}

void ContainerPassages::wallNormals(const Container& container, const RayBatch& rays,
                                    std::span<const std::size_t> lines, bool entering,
                                    std::array<AlignedColumn, 3>& normals) const {
    for (AlignedColumn& column : normals) column.resize(lines.size() + LineColumns::padding);
    const auto* const sphere = std::get_if<ContainerSphere>(&container);
    // The squares of others might overflow or vanish.
    if (sphere != nullptr && sphere->radius > 1e-90 && sphere->radius < 1e90) {
        HWY_DYNAMIC_DISPATCH(turnFromSphere)
        (*sphere, rays, lines.data(), lines.size(), entering,
         {normals[0].data(), normals[1].data(), normals[2].data()});
        return;
    }
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const glm::dvec3 normal = wallNormal(container, rays, lines[k], entering);
        for (int c = 0; c < 3; ++c) normals[static_cast<std::size_t>(c)][k] = normal[c];
    }
}

}  // namespace isoscope
#endif
