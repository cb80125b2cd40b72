// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/newton_polish.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/roots/certified/newton_polish.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>

#include "core/roots/certified/first_roots-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

using Doubles = RootTag;
using Vector = hn::Vec<Doubles>;
using Mask = hn::Mask<Doubles>;
using Crossings = MarchKernel::Crossings;
using Columns = NewtonPolish::Columns;

HWY_INLINE Vector constant(double value) { return hn::Set(Doubles(), value); }
HWY_INLINE Vector load(const double* from) { return hn::LoadU(Doubles(), from); }
HWY_INLINE void save(Vector value, double* to) { hn::StoreU(value, Doubles(), to); }
HWY_INLINE void append(Vector value, Mask mask, double* to) { appendLanes(Doubles(), value, mask, to); }
HWY_INLINE Mask firstLanes(std::size_t count) { return hn::FirstN(Doubles(), count); }

/// The point at `t` on crossing number `i`.
HWY_INLINE void placeAt(Vector t, const Crossings& crossings, std::size_t i, Columns& columns) {
    save(t, columns[NewtonPolish::t] + i);
    for (std::size_t c = 0; c < 3; ++c)
        save(hn::Add(load(crossings[MarchKernel::foundOriginX + c] + i),
                     hn::Mul(t, load(crossings[MarchKernel::foundDirectionX + c] + i))),
             columns[NewtonPolish::x + c] + i);
}

HWY_INLINE Mask holds(const Crossings& crossings, std::size_t i, Vector t) {
    return hn::And(hn::Ge(t, load(crossings[MarchKernel::low] + i)),
                   hn::Le(t, load(crossings[MarchKernel::high] + i)));
}

/// How long the last step of crossing number `i` may be.
HWY_INLINE Vector longestStep(const Crossings& crossings, std::size_t i) {
    const auto column = [&](MarchKernel::Crossing c) HWY_ATTR { return load(crossings[c] + i); };
    const Vector tolerance = column(MarchKernel::foundTolerance);
    const Vector width = hn::Sub(column(MarchKernel::high), column(MarchKernel::low));
    const Vector curvatureRatio = column(MarchKernel::curvatureRatio);
    const Vector leftover = hn::Mul(constant(NewtonPolish::leftover), tolerance);
    const Vector foreseen =
        hn::Div(hn::Sqrt(hn::Mul(leftover, width)), hn::Add(curvatureRatio, curvatureRatio));
    const Vector shortest = hn::Mul(constant(NewtonPolish::lastStep), tolerance);
    const Vector longest = hn::Mul(constant(NewtonPolish::longestStep), tolerance);
    // What is not a number is no more than the shortest.
    return hn::Min(hn::IfThenElse(hn::Gt(foreseen, shortest), foreseen, shortest), longest);
}

void beginInTheMiddle(const Crossings& crossings, Columns& columns) {
    for (std::size_t i = 0; i < crossings.size(); i += hn::Lanes(Doubles())) {
        const Vector low = load(crossings[MarchKernel::low] + i),
                     high = load(crossings[MarchKernel::high] + i);
        placeAt(hn::MulAdd(hn::Sub(high, low), constant(0.5), low), crossings, i, columns);
        save(longestStep(crossings, i), columns[NewtonPolish::longest] + i);
    }
    columns.setSize(crossings.size());
}

/// The lanes of `mask` are not to be settled in this way.
void giveUp(const Crossings& crossings, std::size_t i, Mask mask,
            std::vector<NewtonPolish::Unsettled>& unsettled) {
    HWY_ALIGN double flags[batchLanes];
    save(hn::IfThenElseZero(mask, constant(1)), flags);
    for (std::size_t k = 0; k < hn::Lanes(Doubles()); ++k)
        if (flags[k] != 0)
            unsettled.push_back({static_cast<std::size_t>(crossings[MarchKernel::foundLine][i + k]),
                                 crossings[MarchKernel::low][i + k], crossings[MarchKernel::high][i + k],
                                 crossings[MarchKernel::steepness][i + k]});
}

/// Closes the ranks behind `kept` with the lanes of `mask`.
HWY_INLINE void keep(Crossings& crossings, Columns& columns, std::size_t i, Mask mask, std::size_t& kept) {
    const std::size_t count = hn::CountTrue(Doubles(), mask);
    if (kept != i || count != hn::Lanes(Doubles())) {
        for (std::size_t c = 0; c < MarchKernel::crossingColumns; ++c)
            append(load(crossings[c] + i), mask, crossings[c] + kept);
        for (std::size_t c = 0; c < NewtonPolish::columnCount; ++c)
            append(load(columns[c] + i), mask, columns[c] + kept);
    }
    kept += count;
}

/// One step of Newton's. What settles goes to `roots`, the other crossings stay.
void exactStep(const GradientLanes& gradients, const RootSettings& settings, std::size_t first,
               std::size_t count, Crossings& crossings, Columns& columns, std::size_t& kept,
               FirstRoots& roots, std::vector<NewtonPolish::Unsettled>& unsettled) {
    const Vector threshold = constant(settings.threshold);
    const Vector polarity = constant(settings.positivePolarity ? -1 : 1);
    for (std::size_t k = 0; k < count; k += hn::Lanes(Doubles())) {
        const std::size_t i = first + k;
        const Mask all = firstLanes(count - k);
        const Vector value = hn::Mul(hn::Sub(load(gradients.value + k), threshold), polarity);
        Vector normal[3], slope = hn::Zero(Doubles()), square = slope;
        for (std::size_t c = 0; c < 3; ++c) {
            normal[c] = hn::Mul(load(gradients.gradient[c] + k), polarity);
            slope = hn::MulAdd(normal[c], load(crossings[MarchKernel::foundDirectionX + c] + i), slope);
            square = hn::MulAdd(normal[c], normal[c], square);
        }
        const Vector way = hn::Div(value, slope);
        const Vector next = hn::Sub(load(columns[NewtonPolish::t] + i), way);
        // Also false where there is no gradient to speak of.
        const Mask usual = hn::And(hn::Gt(square, constant(1e-200)), hn::Lt(square, constant(1e200)));
        const Vector width =
            hn::Sub(load(crossings[MarchKernel::high] + i), load(crossings[MarchKernel::low] + i));
        // What is steeper than the enclosure's slope has a kink or a jump.
        const Mask steady =
            hn::Le(hn::Abs(value), hn::Mul(hn::Abs(load(crossings[MarchKernel::steepness] + i)), width));
        const Mask good = hn::And(hn::And(all, hn::And(usual, steady)), holds(crossings, i, next));
        const Mask settled = hn::And(good, hn::Le(hn::Abs(way), load(columns[NewtonPolish::longest] + i)));
        const Mask bad = hn::AndNot(good, all);
        if (!hn::AllFalse(Doubles(), bad)) giveUp(crossings, i, bad, unsettled);
        const Vector length = hn::Sqrt(square);
        for (Vector& coordinate : normal) coordinate = hn::Div(coordinate, length);
        putRoots(settled, load(crossings[MarchKernel::foundLine] + i), next, normal, roots);
        const Mask left = hn::AndNot(settled, good);
        if (hn::AllFalse(Doubles(), left)) continue;
        placeAt(next, crossings, i, columns);
        keep(crossings, columns, i, left, kept);
    }
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(beginInTheMiddle);
HWY_EXPORT(exactStep);

namespace {

/// More steps than these are not tried.
constexpr int exactSteps = 5;

}  // namespace

void NewtonPolish::run(MarchKernel::Crossings& crossings, FirstRoots& roots,
                       const SimplifiedTape* simplifiedTape) {
    unsettled_.clear();
    simplifiedTape_ = simplifiedTape;
    if (crossings.empty()) return;
    columns_.reserve(crossings.size());
    HWY_DYNAMIC_DISPATCH(beginInTheMiddle)(crossings, columns_);
    for (int step = 0; step < exactSteps && !crossings.empty(); ++step) refine(crossings, roots);
    for (std::size_t i = 0; i < crossings.size(); ++i)
        unsettled_.push_back({static_cast<std::size_t>(crossings[MarchKernel::foundLine][i]),
                              crossings[MarchKernel::low][i], crossings[MarchKernel::high][i],
                              crossings[MarchKernel::steepness][i]});
}

void NewtonPolish::refine(MarchKernel::Crossings& crossings, FirstRoots& roots) {
    std::size_t kept = 0;
    const std::size_t size = crossings.size();
    for (std::size_t first = 0; first < size; first += batchLanes) {
        const std::size_t count = std::min(batchLanes, size - first);
        const std::array<const double*, 3> point{columns_[x] + first, columns_[y] + first,
                                                 columns_[z] + first};
        const GradientLanes gradients = simplifiedTape_ != nullptr
                                            ? gradients_.evaluateLanes(point, count, *simplifiedTape_)
                                            : gradients_.evaluateLanes(point, count);
        HWY_DYNAMIC_DISPATCH(exactStep)
        (gradients, settings_, first, count, crossings, columns_, kept, roots, unsettled_);
    }
    crossings.setSize(kept);
    columns_.setSize(kept);
}

}  // namespace isoscope
#endif
