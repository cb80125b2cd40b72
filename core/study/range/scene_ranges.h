// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>
#include <vector>

#include "core/scene/scene.h"
#include "core/study/range/parameter_range.h"

namespace isoscope {

/// A number of a scene that decides where one of its isosurfaces is.
struct RangeSubject {
    std::size_t isosurface = 0;  ///< its number
    std::size_t parameter = 0;   ///< its number among the scene's
    int slot = RangeStudy::threshold;
};

/// All of them, isosurface by isosurface: the threshold of the statement, and the parameters that the
/// function depends on and that a slider moves without a new parse.
std::vector<RangeSubject> rangeSubjects(const Scene& scene);

/// What is known of a subject over a range of its number, at its whole numbers for one that counts. A stop
/// leaves the rest unknown.
ParameterRange rangeOf(const Scene& scene, const RangeSubject& subject, double low, double high,
                       const RangeSettings& settings = {}, std::stop_token stop = {});
/// The same over the range that its slider has at first.
ParameterRange rangeOf(const Scene& scene, const RangeSubject& subject, const RangeSettings& settings = {},
                       std::stop_token stop = {});

}  // namespace isoscope
