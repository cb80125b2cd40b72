// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/roots/line_query.h"
#include "core/roots/root_settings.h"

namespace isoscope {

/// A place on a ray with g there: f - threshold, negative inside (the other way round with positive
/// polarity).
struct ProfilePoint {
    double t = 0;
    double value = 0;
};

/// What POV-Ray's method did with an interval that it did not halve.
enum class IntervalFate : std::uint8_t {
    pruned,     ///< dismissed: a function no steeper than the bound cannot reach the threshold in between
    hit,        ///< shorter than the accuracy, with a step through the threshold
    tooShort,   ///< shorter than the accuracy, without one
    undefined,  ///< dismissed: the function has no value at an end
};

/// An interval of the line, as parameters t, and what became of it.
struct SearchedInterval {
    double low = 0;
    double high = 0;
    IntervalFate fate = IntervalFate::pruned;
};

/// POV-Ray's method (docs/povray/solver.md) along one line, with all that it looks at, in its order.
struct ExplainedSearch {
    RootList roots;  ///< those of LipschitzRootFinder for this line alone
    std::vector<ProfilePoint> visited;
    std::vector<SearchedInterval> intervals;  ///< of all searches of the line
    bool complete = true;                     ///< false when there was more than explainedPointLimit
};

/// At most so many points are visited.
constexpr std::size_t explainedPointLimit = 20'000;

/// `value` is f at a parameter of the line. `settings` are made usable() first.
ExplainedSearch explainSearch(const LineQuery& line, const RootSettings& settings,
                              const std::function<double(double)>& value);

}  // namespace isoscope
