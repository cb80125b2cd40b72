// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/ray_explanation.h"

#include <algorithm>
#include <cmath>
#include <QCoreApplication>

namespace isoscope {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(RayExplanation)
};

QString number(double value) { return QString::number(value, 'g', 5); }

/// Hits this far apart, in units of the accuracy, are on different sheets.
constexpr double sheetShare = 4;

QString cost(const RayProfile& profile) {
    return Words::tr("%1 samples, bound %2 per unit of distance.")
        .arg(profile.povray.visited.size())
        .arg(number(profile.maxGradient));
}

/// The steepest slope of the curve inside an interval: what the bound should have been at least.
double steepestIn(const RayProfile& profile, const SearchedInterval& interval) {
    double steepest = 0;
    for (std::size_t i = 1; i < profile.curve.size(); ++i) {
        const ProfilePoint &a = profile.curve[i - 1], &b = profile.curve[i];
        if (a.t < interval.low || b.t > interval.high) continue;
        const double slope = std::abs(b.value - a.value) / (b.t - a.t);
        if (std::isfinite(slope)) steepest = std::max(steepest, slope);
    }
    return steepest;
}

QString whyMissed(const RayProfile& profile) {
    const auto& intervals = profile.povray.intervals;
    const auto wrong =
        std::find_if(intervals.begin(), intervals.end(),
                     [&](const SearchedInterval& interval) { return profile.wronglyPruned(interval); });
    if (wrong == intervals.end()) return {};
    return Words::tr(
               "It dismissed the interval from %1 to %2, for it takes f to be no steeper than %3; there it "
               "is up to %4.")
        .arg(number(wrong->low), number(wrong->high), number(profile.maxGradient),
             QString::number(steepestIn(profile, *wrong), 'g', 3));
}

}  // namespace

QString rayExplanation(const RayProfile& profile, std::optional<HolePixel> pictured) {
    const RootList &truth = profile.certifiedRoots, &found = profile.povray.roots;
    if (truth.empty() && found.empty()) return Words::tr("Nothing is hit. ") + cost(profile);
    if (truth.empty())
        return Words::tr("POV-Ray's method hits at %1, where nothing is. ").arg(number(found.front().t)) +
               cost(profile);
    const double surface = truth.front().t;
    if (found.empty())
        return Words::tr("POV-Ray's method misses the surface at %1. ").arg(number(surface)) +
               whyMissed(profile);
    const double off = found.front().t - surface;
    if (off < -sheetShare * profile.accuracy)
        return Words::tr("POV-Ray's method hits at %1, where nothing is; the surface is at %2. ")
            .arg(number(found.front().t), number(surface));
    if (off > sheetShare * profile.accuracy)
        return Words::tr("POV-Ray's method misses the surface at %1 and hits further back, at %2. ")
                   .arg(number(surface), number(found.front().t)) +
               whyMissed(profile);
    QString all = Words::tr("POV-Ray's method finds the surface at %1, off by %2. ")
                      .arg(number(surface), QString::number(std::abs(off), 'g', 2));
    if (pictured == HolePixel::lost || pictured == HolePixel::wrongPlace)
        return all +
               Words::tr(
                   "Yet its picture has a hole here: it dismisses rays too close to one that missed before.");
    return all + cost(profile);
}

}  // namespace isoscope
