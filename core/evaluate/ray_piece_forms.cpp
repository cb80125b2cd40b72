// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/ray_piece_forms.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/evaluate/ray_piece_forms.cpp"
#include <hwy/foreach_target.h>

#include "core/evaluate/ray_piece_forms-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

void writeAll(const PieceColumns& pieces, const RaySpread* spread, std::size_t count,
              std::span<double* const> forms) {
    writeForms(pieces, spread, count, forms);
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
