// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/slope_kernel.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/evaluate/slope_kernel.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>

#include "core/evaluate/algebra/slope_algebra-inl.h"
#include "core/evaluate/algebra/tape_interpreter-inl.h"
#include "core/evaluate/ray_piece_forms.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

/// Of one coordinate, whose form is there already.
void writeSlopes(const RayPieces& pieces, const RaySpread& spread, std::size_t axis, std::size_t lanes,
                 double* argument) {
    for (std::size_t i = 0; i < lanes; i += vectorLanes) {
        const auto at = [i](const std::array<double, batchLanes>& lane)
                            HWY_ATTR { return hn::LoadU(Doubles(), &lane[i]); };
        const Vector direction = at(pieces.direction[axis]);
        const Vector apart = hn::Mul(at(spread.direction[axis]), constantVector(inflation));
        // A point is rounded twice: its way from the origin, and its place.
        const AffineNumber form = AffineAlgebra::load(argument + i);
        const Vector size = hn::Add(hn::Abs(form.a), radiusOf(form));
        const Vector end = hn::Add(at(pieces.start), at(pieces.length));
        const Vector way = hn::Mul(hn::Add(hn::Abs(direction), apart), end);
        const Vector rounding =
            hn::MulAdd(hn::Add(size, way), constantVector(2 * roundingUnit), constantVector(underflow));
        hn::StoreU(direction, Doubles(), argument + i + 3 * batchLanes);
        hn::StoreU(apart, Doubles(), argument + i + 4 * batchLanes);
        hn::StoreU(rounding, Doubles(), argument + i + 5 * batchLanes);
    }
}

void writeAllSlopes(const RayPieces& pieces, const RaySpread& spread, std::size_t lanes,
                    std::span<double* const> arguments) {
    for (std::size_t axis = 0; axis < arguments.size(); ++axis)
        writeSlopes(pieces, spread, axis, lanes, arguments[axis]);
}

void runSlopes(TapeWorkspace& workspace, std::size_t lanes) {
    TapeInterpreter<SlopeAlgebra, false>(workspace, lanes).run();
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(writeAllSlopes);
HWY_EXPORT(runSlopes);

void writeSlopeArguments(const RayPieces& pieces, const RaySpread& spread, std::size_t lanes,
                         TapeWorkspace& workspace) {
    const auto count = static_cast<std::size_t>(std::min(3, workspace.tape().argumentCount()));
    std::array<double*, 3> arguments{};
    for (std::size_t k = 0; k < count; ++k) arguments[k] = workspace.slot(static_cast<Slot>(k));
    const std::span<double* const> used = std::span(arguments).first(count);
    writeRayPieceForms(pieces.columns(), &spread, lanes, used);
    HWY_DYNAMIC_DISPATCH(writeAllSlopes)(pieces, spread, lanes, used);
}

void runSlopeTape(TapeWorkspace& workspace, std::size_t lanes) {
    HWY_DYNAMIC_DISPATCH(runSlopes)(workspace, lanes);
}

}  // namespace isoscope
#endif
