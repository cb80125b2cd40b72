// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <set>
#include <string>
#include <vector>

#include "core/animation/timeline.h"

namespace isoscope {

/// What one row of a TimelineView stands for: the track of a number, or all those of the camera together.
struct TimelineRow {
    QString title;
    std::vector<std::string> tracks;  ///< their names
    bool missing = false;             ///< the text has no such number
    bool operator==(const TimelineRow&) const = default;

    /// The frames at which any of its tracks has a key.
    std::set<int> frames(const Timeline& timeline) const;
    /// Whether one of them is this frame.
    bool hasKey(const Timeline& timeline, int frame) const;
    /// Values and ways of the keys at a frame, in words; empty without any.
    QString told(const Timeline& timeline, int frame) const;
    /// The way behind the keys at a frame: that of the first one.
    Easing easing(const Timeline& timeline, int frame) const;
};

/// The rows of a timeline, the camera last. `missing` are names that no number of the text has.
std::vector<TimelineRow> timelineRows(const Timeline& timeline, const std::vector<std::string>& missing);

/// What people call an easing.
QString easingTitle(Easing easing);

}  // namespace isoscope
