// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "core/scene/scene.h"
#include "core/study/threshold/critical_study.h"

namespace isoscope {

/// How often which values of a function occur in its container, in bins of equal width. The rarest values at
/// both ends are left out where they would leave no room for the others.
struct ValueHistogram {
    std::vector<double> edges;   ///< one more than bins; empty when there are no finite values
    std::vector<double> shares;  ///< of the container's volume

    /// Whether nothing was sampled.
    bool empty() const { return edges.empty(); }
};

/// Samples the container at evenly spread points. Empty for containers that are not finite and when stopped.
ValueHistogram valueHistogram(const Isosurface& surface, std::span<const double> parameters,
                              std::stop_token stop = {});

/// All that is known of the thresholds of one isosurface.
struct ThresholdSurvey {
    ValueHistogram histogram;
    CriticalPoints critical;
    double progress = 0;    ///< of the search for critical points, from 0 to 1
    bool complete = false;  ///< the search has ended
};

/// The histogram first, then the progress several times a second, at last the critical points. After a stop
/// no more is reported, nor for a scene without that isosurface.
void surveyThresholds(const Scene& scene, std::size_t isosurface, const CriticalStudySettings& settings,
                      const std::function<void(const ThresholdSurvey&)>& report, std::stop_token stop = {});

/// Critical points with one value, as far as numbers tell: what one tick of an axis stands for.
struct ThresholdTick {
    double value = 0;
    std::vector<CriticalPoint> points;  ///< the proven ones first

    /// Whether one of them is.
    bool proven() const { return points.front().proven(); }
};

/// The points in groups of one value, ascending.
std::vector<ThresholdTick> thresholdTicks(const CriticalPoints& critical);

}  // namespace isoscope
