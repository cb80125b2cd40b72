// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/tangent_polish.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/roots/certified/tangent_polish.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <limits>

#include "core/roots/certified/first_roots-inl.h"

#ifndef ISOSCOPE_ROOTS_TANGENT_POLISH_ONCE
#define ISOSCOPE_ROOTS_TANGENT_POLISH_ONCE
namespace isoscope {

/// The middles of brackets, and half their lengths.
struct BracketPlaces {
    alignas(64) std::array<double, batchLanes> t, reach;
};

}  // namespace isoscope
#endif

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

using Vector = hn::Vec<RootTag>;
using Mask = hn::Mask<RootTag>;
using March = MarchKernel;

constexpr double unit = std::numeric_limits<double>::epsilon();

HWY_INLINE Vector constant(double value) { return hn::Set(RootTag(), value); }
HWY_INLINE Vector load(const double* from) { return hn::LoadU(RootTag(), from); }

void findMiddles(const March::Columns& brackets, std::size_t first, std::size_t count,
                 BracketPlaces& places) {
    for (std::size_t k = 0; k < count; k += hn::Lanes(RootTag())) {
        const Vector half = hn::Mul(load(brackets[March::length] + first + k), constant(0.5));
        const Vector t = hn::Add(load(brackets[March::start] + first + k), half);
        hn::Store(t, RootTag(), places.t.data() + k);
        // The middle is rounded.
        hn::Store(hn::MulAdd(hn::Add(hn::Abs(t), half), constant(2 * unit), half), RootTag(),
                  places.reach.data() + k);
    }
}

/// Where the roots are, in parts of the reach: no further than `error` from `place`.
struct RootPlace {
    Vector place, error;
};

/// A root s has |value + slope s| <= remainder s^2 + rounding: each bound on |s| gives a closer one.
HWY_INLINE RootPlace placeOf(Vector value, Vector slope, Vector remainder, Vector rounding) {
    const Vector perSlope = hn::Div(constant(1 + 8 * unit), hn::Abs(slope));
    const Vector place = hn::Neg(hn::Div(value, slope));
    Vector farthest = constant(1), error = farthest;
    for (int round = 0; round < 3; ++round) {
        error = hn::Mul(hn::MulAdd(remainder, hn::Mul(farthest, farthest), rounding), perSlope);
        farthest = hn::Min(hn::MulAdd(hn::Abs(place), constant(1 + 2 * unit), error), constant(1));
    }
    return {place, error};
}

/// A crossing around t, and how far the function may be from straight there, in the terms of MarchKernel.
struct NarrowCrossing {
    Vector t, error, steepness, curvatureRatio;
};

HWY_INLINE void appendCrossings(Mask where, const NarrowCrossing& found, const March::Columns& brackets,
                                std::size_t i, March::Crossings& crossings) {
    const std::size_t size = crossings.size();
    const auto put = [&](March::Crossing column, Vector value)
                         HWY_ATTR { appendLanes(RootTag(), value, where, crossings[column] + size); };
    put(March::foundLine, load(brackets[March::line] + i));
    put(March::low, hn::Sub(found.t, found.error));
    put(March::high, hn::Add(found.t, found.error));
    put(March::steepness, found.steepness);
    put(March::curvatureRatio, found.curvatureRatio);
    put(March::foundTolerance, load(brackets[March::tolerance] + i));
    for (std::size_t c = 0; c < 6; ++c)
        appendLanes(RootTag(), load(brackets[March::originX + c] + i), where,
                    crossings[March::foundOriginX + c] + size);
    crossings.setSize(size + hn::CountTrue(RootTag(), where));
}

/// What settles goes to `roots`, what is narrow to `crossings`; the other brackets stay.
void settleAll(const TaylorLanes& tangents, const BracketPlaces& places, const RootSettings& settings,
               double sufficient, std::size_t first, std::size_t count, March::Columns& brackets,
               std::size_t& kept, March::Crossings& crossings, FirstRoots& roots) {
    const Vector threshold = constant(settings.threshold);
    const Vector polarity = constant(settings.positivePolarity ? -1 : 1);
    for (std::size_t k = 0; k < count; k += hn::Lanes(RootTag())) {
        const std::size_t i = first + k;
        const Mask all = hn::FirstN(RootTag(), count - k);
        const Vector value = load(tangents.point.value + k), slope = load(tangents.slope + k);
        const Vector remainder = load(tangents.remainder + k);
        const Vector rounding = hn::MulAdd(hn::Abs(value), constant(2 * unit), load(tangents.rounding + k));
        const RootPlace found = placeOf(hn::Sub(value, threshold), slope, remainder, rounding);
        const Vector t0 = load(places.t.data() + k), reach = load(places.reach.data() + k);
        const Vector t = hn::MulAdd(found.place, reach, t0), error = hn::Mul(found.error, reach);

        Vector normal[3], square = hn::Zero(RootTag());
        for (std::size_t c = 0; c < 3; ++c) {
            normal[c] = load(tangents.point.gradient[c] + k);
            square = hn::MulAdd(normal[c], normal[c], square);
        }
        // Comparisons are also false for what is not a number.
        const Vector tolerance = load(brackets[March::tolerance] + i);
        const Vector leftover = hn::Mul(tolerance, constant(TangentPolish::leftover));
        const Vector turn =
            hn::Div(hn::Mul(hn::Add(remainder, remainder), hn::Abs(found.place)), hn::Abs(slope));
        const Vector low = load(brackets[March::start] + i);
        const Mask inside = hn::And(hn::Ge(t, hn::Max(low, constant(sufficient))),
                                    hn::Le(t, hn::Add(low, load(brackets[March::length] + i))));
        const Mask usual = hn::And(hn::Gt(square, constant(1e-200)), hn::Lt(square, constant(1e200)));
        const Mask close = hn::And(hn::Le(error, leftover), hn::Le(turn, constant(TangentPolish::turn)));
        const Mask settled = hn::And(hn::And(all, usual), hn::And(inside, close));
        const Vector length = hn::Div(polarity, hn::Sqrt(square));
        for (Vector& coordinate : normal) coordinate = hn::Mul(coordinate, length);
        putRoots(settled, load(brackets[March::line] + i), t, normal, roots);
        Mask left = hn::AndNot(settled, all);
        const Mask narrow = hn::And(hn::And(left, inside), hn::Le(hn::Add(error, error), tolerance));
        if (!hn::AllFalse(RootTag(), narrow)) {
            const Vector steepness = hn::Div(hn::Mul(slope, polarity), reach);
            const Vector curved =
                hn::Div(hn::Mul(remainder, error), hn::Mul(hn::Abs(steepness), hn::Add(reach, reach)));
            appendCrossings(narrow, {t, error, steepness, hn::Sqrt(curved)}, brackets, i, crossings);
            left = hn::AndNot(narrow, left);
        }
        if (hn::AllFalse(RootTag(), left)) continue;
        for (std::size_t c = 0; c < March::columnCount; ++c)
            appendLanes(RootTag(), load(brackets[c] + i), left, brackets[c] + kept);
        kept += hn::CountTrue(RootTag(), left);
    }
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(findMiddles);
HWY_EXPORT(settleAll);

void TangentPolish::run(MarchKernel::Results& found, double sufficient, const SimplifiedTape* simplifiedTape,
                        FirstRoots& roots) {
    MarchKernel::Columns& brackets = found.brackets;
    found.crossings.reserve(found.crossings.size() + brackets.size());
    std::size_t kept = 0;
    BracketPlaces places;
    for (std::size_t first = 0; first < brackets.size(); first += batchLanes) {
        const std::size_t count = std::min(batchLanes, brackets.size() - first);
        HWY_DYNAMIC_DISPATCH(findMiddles)(brackets, first, count, places);
        RayPlaces rays;
        for (std::size_t c = 0; c < 3; ++c) {
            rays.origin[c] = brackets[MarchKernel::originX + c] + first;
            rays.direction[c] = brackets[MarchKernel::directionX + c] + first;
        }
        rays.t = places.t.data();
        rays.reach = places.reach.data();
        const TaylorLanes tangents = tangents_.evaluate(rays, count, simplifiedTape);
        HWY_DYNAMIC_DISPATCH(settleAll)
        (tangents, places, settings_, sufficient, first, count, brackets, kept, found.crossings, roots);
    }
    brackets.setSize(kept);
}

}  // namespace isoscope
#endif
