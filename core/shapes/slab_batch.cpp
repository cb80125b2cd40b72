// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/slab_batch.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/shapes/slab_batch.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cmath>
#include <limits>

#include "core/shapes/vector_triple-inl.h"

#ifndef ISOSCOPE_SHAPES_SLAB_BATCH_ONCE
#define ISOSCOPE_SHAPES_SLAB_BATCH_ONCE
namespace isoscope {

/// The columns of a batch.
struct SlabColumns {
    const double* origin[3];
    const double* inverse[3];
    const double* reach;
    std::size_t size;
};

}  // namespace isoscope
#endif

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

/// SlabRay::mayMeet for the rays from k on.
HWY_INLINE hn::Mask<Doubles> mayMeet(const SlabColumns& rays, std::size_t k, const Triple& low,
                                     const Triple& high, Vector far) {
    const Doubles d;
    const Vector room = constant(1e-12);
    Vector near = hn::Zero(d);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Vector origin = hn::LoadU(d, rays.origin[axis] + k);
        const Vector inverse = hn::LoadU(d, rays.inverse[axis] + k);
        const Vector toLow = hn::Mul(hn::Sub(low[axis], origin), inverse);
        const Vector toHigh = hn::Mul(hn::Sub(high[axis], origin), inverse);
        const auto backwards = hn::Lt(inverse, hn::Zero(d));
        const Vector in = hn::IfThenElse(backwards, toHigh, toLow);
        const Vector out = hn::IfThenElse(backwards, toLow, toHigh);
        // 0 times infinity, on the very wall of a flat slab, is no reason to miss the box.
        near = hn::IfThenElse(hn::Gt(in, near), in, near);
        far = hn::IfThenElse(hn::Lt(out, far), out, far);
    }
    near = hn::Sub(near, hn::Mul(room, hn::Abs(near)));
    return hn::Le(near, hn::Add(far, hn::Mul(room, hn::Abs(far))));
}

void findMeeting(const SlabColumns& rays, const Bounds& box, const double* farthest,
                 std::vector<std::uint32_t>& numbers) {
    const Doubles d;
    const Triple low = constant(box.low), high = constant(box.high);
    for (std::size_t k = 0; k < rays.size; k += hn::Lanes(d)) {
        const Vector far = hn::Min(hn::LoadU(d, farthest + k), hn::LoadU(d, rays.reach + k));
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, mayMeet(rays, k, low, high, far), bits);
        for (unsigned rest = bits[0], lane = 0; rest != 0; rest >>= 1, ++lane)
            if ((rest & 1u) != 0 && k + lane < rays.size)
                numbers.push_back(static_cast<std::uint32_t>(k + lane));
    }
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(findMeeting);

void SlabBatch::assign(std::span<const Ray> rays) {
    columns_.clear();
    columns_.reserve(rays.size());
    columns_.setSize(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        bool usable = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<int>(k);
            const double origin = rays[i].origin[axis], direction = rays[i].direction[axis];
            columns_[originX + k][i] = origin;
            columns_[inverseX + k][i] = 1 / direction;
            usable &= std::isfinite(origin) && std::isfinite(direction);
        }
        columns_[reach][i] = usable ? std::numeric_limits<double>::infinity() : -1;
    }
}

void SlabBatch::findMeeting(const Bounds& box, const double* farthest,
                            std::vector<std::uint32_t>& numbers) const {
    const SlabColumns columns{{columns_[originX], columns_[originY], columns_[originZ]},
                              {columns_[inverseX], columns_[inverseY], columns_[inverseZ]},
                              columns_[reach],
                              columns_.size()};
    numbers.clear();
    HWY_DYNAMIC_DISPATCH(findMeeting)(columns, box, farthest, numbers);
}

}  // namespace isoscope
#endif
