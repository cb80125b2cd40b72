// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/cost_plot.h"

#include <algorithm>
#include <cmath>

#include "core/shapes/trace_context.h"

namespace isoscope {

namespace {

/// Sliders round their values a little.
bool isSame(double a, double b) { return std::abs(a / b - 1) < 1e-6; }

}  // namespace

std::array<const CostPlot::Mark*, 2> CostPlot::around(double value) const {
    for (const Mark& mark : marks)
        if (isSame(mark.setting, value)) return {&mark, &mark};
    const auto above =
        std::find_if(marks.begin(), marks.end(), [&](const Mark& mark) { return mark.setting > value; });
    if (above == marks.begin() || above == marks.end()) return {};
    return {&*(above - 1), &*above};
}

std::optional<double> CostPlot::secondsAt(double value, std::size_t finder) const {
    const auto [low, high] = around(value);
    if (!low) return {};
    if (finder == static_cast<std::size_t>(RootFinder::lipschitz) && isSame(present, value))
        return presentSeconds;
    const double from = low->seconds[finder], to = high->seconds[finder];
    if (low == high || !(from > 0) || !(to > 0)) return from;
    const double share = std::log(value / low->setting) / std::log(high->setting / low->setting);
    return from * std::pow(to / from, share);
}

}  // namespace isoscope
