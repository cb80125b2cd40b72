// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/povray_hits.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/roots/povray_hits.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/roots/line_columns.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::CappedTag<double, LineColumns::padding / 4>;
using Vector = hn::Vec<Doubles>;
using Mask = hn::Mask<Doubles>;

/// A step waits for the one before it; those of other vectors go on meanwhile.
constexpr std::size_t vectors = 4;

void endAll(std::size_t count, double tolerance, const double* root, double* near, double* far) {
    const Doubles d;
    const std::size_t lanes = hn::Lanes(d);
    const Vector half = hn::Set(d, 0.5), least = hn::Set(d, tolerance);
    for (std::size_t first = 0; first < count; first += vectors * lanes) {
        Vector low[vectors], high[vectors], at[vectors];
        Mask wide[vectors];
        for (std::size_t v = 0; v < vectors; ++v) {
            const std::size_t i = first + v * lanes;
            low[v] = hn::LoadU(d, near + i);
            high[v] = hn::LoadU(d, far + i);
            at[v] = hn::LoadU(d, root + i);
            // Nothing is known of the numbers behind the last line.
            high[v] = hn::IfThenElse(hn::FirstN(d, i < count ? count - i : 0), high[v], low[v]);
        }
        for (bool goesOn = true; goesOn;) {
            Mask some = hn::Lt(half, hn::Zero(d));
            for (std::size_t v = 0; v < vectors; ++v) {
                const Vector middle = hn::Mul(hn::Add(low[v], high[v]), half);
                wide[v] = hn::Ge(hn::Sub(high[v], low[v]), least);
                const Mask parts = hn::And(hn::Lt(low[v], middle), hn::Lt(middle, high[v]));
                const Mask halves = hn::And(wide[v], parts);
                const Mask before = hn::Le(at[v], middle);
                high[v] = hn::IfThenElse(hn::And(halves, before), middle, high[v]);
                low[v] = hn::IfThenElse(hn::AndNot(before, halves), middle, low[v]);
                some = hn::Or(some, halves);
            }
            goesOn = !hn::AllFalse(d, some);
        }
        for (std::size_t v = 0; v < vectors; ++v)
            hn::StoreU(hn::IfThenElse(wide[v], at[v], high[v]), d, far + first + v * lanes);
    }
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(endAll);

void endPovrayHalvings(std::size_t count, double tolerance, const double* root, double* near, double* far) {
    HWY_DYNAMIC_DISPATCH(endAll)(count, tolerance, root, near, far);
}

}  // namespace isoscope
#endif
