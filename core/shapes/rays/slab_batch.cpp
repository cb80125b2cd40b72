// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/rays/slab_batch.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/shapes/rays/slab_batch.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <limits>

#include "core/shapes/patches/vector_triple-inl.h"

#ifndef ISOSCOPE_SHAPES_SLAB_BATCH_ONCE
#define ISOSCOPE_SHAPES_SLAB_BATCH_ONCE
namespace isoscope {

/// The columns of a batch.
template <class Number>
struct SlabColumns {
    Number* origin[3];
    Number* inverse[3];
    Number* reach;
    std::size_t size;
};

/// The boxes around the origins and the directions of rays; meaningless unless all are finite.
struct RayExtent {
    Bounds origins{glm::dvec3(std::numeric_limits<double>::infinity()),
                   glm::dvec3(-std::numeric_limits<double>::infinity())};
    Bounds directions = origins;
    bool finite = true;
};

}  // namespace isoscope
#endif

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

using Present = hn::Mask<Doubles>;

/// The span of a column's numbers.
struct Span {
    Vector low, high;

    HWY_INLINE Span()
        : low(constant(std::numeric_limits<double>::infinity())),
          high(constant(-std::numeric_limits<double>::infinity())) {}
    HWY_INLINE void add(Vector a, Present present) {
        low = hn::IfThenElse(present, hn::Min(low, a), low);
        high = hn::IfThenElse(present, hn::Max(high, a), high);
    }
};

void prepare(const RayBatch& rays, const SlabColumns<double>& to, RayExtent& extent) {
    const Doubles d;
    const auto origin = rays.origins(), direction = rays.directions();
    Span origins[3], directions[3];
    for (std::size_t k = 0; k < to.size; k += hn::Lanes(d)) {
        const Present present = hn::FirstN(d, std::min(to.size - k, hn::Lanes(d)));
        Present usable = hn::FirstN(d, hn::Lanes(d));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Vector from = hn::LoadU(d, origin[axis] + k), along = hn::LoadU(d, direction[axis] + k);
            hn::StoreU(from, d, to.origin[axis] + k);
            hn::StoreU(hn::Div(constant(1), along), d, to.inverse[axis] + k);
            usable = hn::And(usable, hn::And(finite(from), finite(along)));
            origins[axis].add(from, present);
            directions[axis].add(along, present);
        }
        hn::StoreU(hn::IfThenElse(usable, constant(std::numeric_limits<double>::infinity()), constant(-1)), d,
                   to.reach + k);
        extent.finite &= hn::AllFalse(d, hn::AndNot(usable, present));
    }
    for (int axis = 0; axis < 3; ++axis) {
        const auto bound = [&](const Span& span, Bounds& box) {
            box.low[axis] = hn::GetLane(hn::MinOfLanes(d, span.low));
            box.high[axis] = hn::GetLane(hn::MaxOfLanes(d, span.high));
        };
        bound(origins[axis], extent.origins);
        bound(directions[axis], extent.directions);
    }
}

/// A vector of rays.
struct Slabs {
    Triple origin, inverse;
    Vector far;
};

/// SlabRay::mayMeet; bit number k answers for lane k.
HWY_INLINE unsigned mayMeet(const Slabs& rays, const Triple& low, const Triple& high) {
    const Doubles d;
    const Vector room = constant(1e-12);
    Vector near = hn::Zero(d), far = rays.far;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Vector toLow = hn::Mul(hn::Sub(low[axis], rays.origin[axis]), rays.inverse[axis]);
        const Vector toHigh = hn::Mul(hn::Sub(high[axis], rays.origin[axis]), rays.inverse[axis]);
        const auto backwards = hn::Lt(rays.inverse[axis], hn::Zero(d));
        const Vector in = hn::IfThenElse(backwards, toHigh, toLow);
        const Vector out = hn::IfThenElse(backwards, toLow, toHigh);
        // 0 times infinity, on the very wall of a flat slab, is no reason to miss the box.
        near = hn::IfThenElse(hn::Gt(in, near), in, near);
        far = hn::IfThenElse(hn::Lt(out, far), out, far);
    }
    near = hn::Sub(near, hn::Mul(room, hn::Abs(near)));
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Le(near, hn::Add(far, hn::Mul(room, hn::Abs(far)))), bits);
    return bits[0];
}

/// The rays from number k on.
HWY_INLINE Slabs slabsFrom(const SlabColumns<const double>& rays, const double* farthest, std::size_t k) {
    const Doubles d;
    Slabs result{load(rays.origin, k), load(rays.inverse, k), hn::LoadU(d, rays.reach + k)};
    if (farthest != nullptr) result.far = hn::Min(hn::LoadU(d, farthest + k), result.far);
    return result;
}

/// The rays with these numbers, as many as a vector has lanes.
HWY_INLINE Slabs slabsOf(const SlabColumns<const double>& rays, const double* farthest,
                         const std::int32_t* numbers) {
    const Doubles d;
    const hn::RebindToSigned<Doubles> indices;
    const auto at = hn::PromoteTo(indices, hn::LoadU(hn::Rebind<std::int32_t, Doubles>(), numbers));
    const auto gather = [&](const double* column) { return hn::GatherIndex(d, column, at); };
    const auto& [origin, inverse, reach, size] = rays;
    Slabs result{{gather(origin[0]), gather(origin[1]), gather(origin[2])},
                 {gather(inverse[0]), gather(inverse[1]), gather(inverse[2])},
                 gather(reach)};
    if (farthest != nullptr) result.far = hn::Min(gather(farthest), result.far);
    return result;
}

void findMeeting(const SlabColumns<const double>& rays, const Bounds& box, const double* farthest,
                 std::vector<std::uint32_t>& numbers) {
    const Doubles d;
    const Triple low = constant(box.low), high = constant(box.high);
    for (std::size_t k = 0; k < rays.size; k += hn::Lanes(d)) {
        const unsigned bits = mayMeet(slabsFrom(rays, farthest, k), low, high);
        for (unsigned rest = bits, lane = 0; rest != 0; rest >>= 1, ++lane)
            if ((rest & 1u) != 0 && k + lane < rays.size)
                numbers.push_back(static_cast<std::uint32_t>(k + lane));
    }
}

std::size_t keepMeeting(const SlabColumns<const double>& rays, const Bounds& box, const double* farthest,
                        const std::uint32_t* among, std::size_t count, std::uint32_t* kept) {
    const Doubles d;
    const std::size_t lanes = hn::Lanes(d);
    const Triple low = constant(box.low), high = constant(box.high);
    std::size_t size = 0;
    for (std::size_t k = 0; k < count; k += lanes) {
        const std::size_t here = std::min(lanes, count - k);
        const bool together = here == lanes && among[k + lanes - 1] - among[k] == lanes - 1;
        std::int32_t numbers[8];
        for (std::size_t lane = 0; lane < lanes && !together; ++lane)
            numbers[lane] = static_cast<std::int32_t>(among[k + std::min(lane, here - 1)]);
        const unsigned bits = mayMeet(
            together ? slabsFrom(rays, farthest, among[k]) : slabsOf(rays, farthest, numbers), low, high);
        for (std::size_t lane = 0; lane < here; ++lane) {
            kept[size] = among[k + lane];
            size += (bits >> lane) & 1u;
        }
    }
    return size;
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(prepare);
HWY_EXPORT(findMeeting);
HWY_EXPORT(keepMeeting);

namespace {

template <class Number, class Table>
SlabColumns<Number> columnsOf(Table& table) {
    return {{table[0], table[1], table[2]}, {table[3], table[4], table[5]}, table[6], table.size()};
}

}  // namespace

void SlabBatch::assign(const RayBatch& rays) {
    static_assert(originX == 0 && inverseX == 3 && reach == 6);
    columns_.reserve(rays.size());
    columns_.setSize(rays.size());
    RayExtent extent;
    HWY_DYNAMIC_DISPATCH(prepare)(rays, columnsOf<double>(columns_), extent);
    bundle_ = extent.finite ? RayBundle(extent.origins, extent.directions) : RayBundle({}, {});
}

void SlabBatch::findMeeting(const Bounds& box, const double* farthest,
                            std::vector<std::uint32_t>& numbers) const {
    numbers.clear();
    HWY_DYNAMIC_DISPATCH(findMeeting)(columnsOf<const double>(columns_), box, farthest, numbers);
}

std::size_t SlabBatch::keepMeeting(const Bounds& box, const double* farthest, const std::uint32_t* among,
                                   std::size_t count, std::uint32_t* kept) const {
    return HWY_DYNAMIC_DISPATCH(keepMeeting)(columnsOf<const double>(columns_), box, farthest, among, count,
                                             kept);
}

}  // namespace isoscope
#endif
