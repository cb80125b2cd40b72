// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/ray_piece_forms.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/evaluate/ray_piece_forms.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

void writeForms(const PieceColumns& pieces, const RaySpread* spread, std::size_t axis, std::size_t count,
                double* forms) {
    const hn::CappedTag<double, batchLanes> doubles;
    const auto oneHalf = hn::Set(doubles, 0.5);
    for (std::size_t i = 0; i < count; i += hn::Lanes(doubles)) {
        const auto origin = hn::LoadU(doubles, &pieces.origin[axis][i]);
        const auto direction = hn::LoadU(doubles, &pieces.direction[axis][i]);
        const auto half = hn::Mul(oneHalf, hn::LoadU(doubles, &pieces.length[i]));
        const auto along = hn::Mul(hn::Add(hn::LoadU(doubles, &pieces.start[i]), half), direction);
        const auto center = hn::Add(origin, along), slope = hn::Mul(half, direction);
        // Four roundings: of the middle, two of the center, one of the slope.
        const auto size = hn::Add(hn::Add(hn::Abs(center), hn::Abs(along)), hn::Abs(slope));
        auto error = hn::Add(hn::Mul(size, hn::Set(doubles, 2.5e-16)),
                             hn::Set(doubles, std::numeric_limits<double>::min()));
        if (spread != nullptr) {
            const auto end = hn::Add(hn::Add(half, half), hn::LoadU(doubles, &pieces.start[i]));
            const auto reach = hn::MulAdd(end, hn::LoadU(doubles, &spread->direction[axis][i]),
                                          hn::LoadU(doubles, &spread->origin[axis][i]));
            // Six roundings, of numbers that are not negative.
            error = hn::MulAdd(reach, hn::Set(doubles, 1 + 1e-15), error);
        }
        hn::StoreU(center, doubles, forms + i);
        hn::StoreU(slope, doubles, forms + batchLanes + i);
        hn::StoreU(error, doubles, forms + 2 * batchLanes + i);
    }
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(writeForms);

void writeRayPieceForms(const PieceColumns& pieces, const RaySpread* spread, std::size_t axis,
                        std::size_t count, double* forms) {
    HWY_DYNAMIC_DISPATCH(writeForms)(pieces, spread, axis, count, forms);
}

}  // namespace isoscope
#endif
