// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. The coordinates of pieces of rays as affine forms.
#if defined(ISOSCOPE_EVALUATE_RAY_PIECE_FORMS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_RAY_PIECE_FORMS_INL
#undef ISOSCOPE_EVALUATE_RAY_PIECE_FORMS_INL
#else
#define ISOSCOPE_EVALUATE_RAY_PIECE_FORMS_INL
#endif

#include <hwy/highway.h>

#include <limits>

#include "core/evaluate/algebra/elementary-inl.h"
#include "core/evaluate/ray_piece_forms.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

template <bool spreads>
HWY_INLINE void writeFormsOf(const PieceColumns& pieces, const RaySpread* spread, std::size_t count,
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
    // Vectors are evaluated whole: an odd number behind the last form would take a function's slow way.
    const std::size_t whole = (count + hn::Lanes(d) - 1) / hn::Lanes(d) * hn::Lanes(d);
    for (std::size_t i = count; i < whole; ++i)
        for (double* const form : forms)
            for (std::size_t part = 0; part < 3; ++part)
                form[part * batchLanes + i] = form[part * batchLanes + count - 1];
}

/// As writeRayPieceForms().
HWY_INLINE void writeForms(const PieceColumns& pieces, const RaySpread* spread, std::size_t count,
                           std::span<double* const> forms) {
    if (spread != nullptr)
        writeFormsOf<true>(pieces, spread, count, forms);
    else
        writeFormsOf<false>(pieces, spread, count, forms);
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
