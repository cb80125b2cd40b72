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

using Doubles = hn::CappedTag<double, batchLanes>;
using Vector = hn::Vec<Doubles>;

template <bool spreads>
void writeForms(const PieceColumns& pieces, const RaySpread* spread, std::size_t count,
                std::span<double* const> forms) {
    const Doubles d;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const Vector start = hn::LoadU(d, &pieces.start[i]);
        const Vector half = hn::Mul(hn::Set(d, 0.5), hn::LoadU(d, &pieces.length[i]));
        const Vector middle = hn::Add(start, half);
        for (std::size_t axis = 0; axis < forms.size(); ++axis) {
            const Vector direction = hn::LoadU(d, &pieces.direction[axis][i]);
            const Vector along = hn::Mul(middle, direction);
            const Vector center = hn::Add(hn::LoadU(d, &pieces.origin[axis][i]), along);
            const Vector slope = hn::Mul(half, direction);
            // Four roundings: of the middle, two of the center, one of the slope.
            const Vector size = hn::Add(hn::Add(hn::Abs(center), hn::Abs(along)), hn::Abs(slope));
            Vector error =
                hn::MulAdd(size, hn::Set(d, 2.5e-16), hn::Set(d, std::numeric_limits<double>::min()));
            if constexpr (spreads) {
                const Vector end = hn::Add(hn::Add(half, half), start);
                const Vector reach = hn::MulAdd(end, hn::LoadU(d, &spread->direction[axis][i]),
                                                hn::LoadU(d, &spread->origin[axis][i]));
                // Six roundings, of numbers that are not negative.
                error = hn::MulAdd(reach, hn::Set(d, 1 + 1e-15), error);
            }
            double* const to = forms[axis] + i;
            hn::StoreU(center, d, to);
            hn::StoreU(slope, d, to + batchLanes);
            hn::StoreU(error, d, to + 2 * batchLanes);
        }
    }
}

void writeAll(const PieceColumns& pieces, const RaySpread* spread, std::size_t count,
              std::span<double* const> forms) {
    if (spread != nullptr)
        writeForms<true>(pieces, spread, count, forms);
    else
        writeForms<false>(pieces, spread, count, forms);
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(writeAll);

void writeRayPieceForms(const PieceColumns& pieces, const RaySpread* spread, std::size_t count,
                        std::span<double* const> forms) {
    HWY_DYNAMIC_DISPATCH(writeAll)(pieces, spread, count, forms);
}

}  // namespace isoscope
#endif
