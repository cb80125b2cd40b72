// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/render_statistics.h"

#include "core/render/light/secondary_ray_queue.h"
#include "core/text/number_format.h"

namespace isoscope {

namespace {

std::string sentence(const char* verdict, const RootFinderReport& report) {
    return "the steepest slope met was " + fixedNumber(report.steepest, 3) + ", max_gradient is " +
           fixedNumber(report.maxGradient, 3) + "; " + verdict;
}

}  // namespace

std::string gradientWarning(const RootFinderReport& report) {
    const double set = report.maxGradient;
    const double found = report.steepest;
    if (!(found > 0) || !(set > 0)) return {};
    const double ratio = set / found;
    const bool holes =
        (ratio <= 0.9 && found - set >= 0.5) || (set < 10 && (ratio <= 0.95 || found - set >= 0.1));
    if (holes) return sentence("the surface may have holes", report);
    const bool wasteful = set - found >= 10 || (ratio >= 1.1 && set - found >= 0.5);
    if (wasteful) return sentence("a smaller value may be faster", report);
    return {};
}

std::string cutWarning(const RenderStatistics& statistics) {
    if (statistics.cutSamples == 0) return {};
    return std::to_string(statistics.cutSamples) +
           (statistics.cutSamples == 1 ? " sample of the picture sends" : " samples of the picture send") +
           " more than " + std::to_string(SecondaryRayQueue::rayLimit) +
           " rays from surface to surface; what these would show is black. A smaller max_trace_level or a "
           "greater adc_bailout needs fewer";
}

}  // namespace isoscope
