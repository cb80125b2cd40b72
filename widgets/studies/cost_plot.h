// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <QSize>
#include <vector>

#include "core/study/accuracy/studied_setting.h"

namespace isoscope {

/// What is known of the cost of a setting, for a strip under its slider. Entries of arrays are by RootFinder.
struct CostPlot {
    /// One measured value of the setting.
    struct Mark {
        double setting = 0;
        std::array<double, 2>
            seconds{};                  ///< of the whole picture: POV-Ray's, and ours by the certified finder
        std::array<quint64, 2> lost{};  ///< pixels of the small picture

        bool operator==(const Mark&) const = default;
    };

    StudiedSetting setting = StudiedSetting::accuracy;
    std::vector<Mark> marks;     ///< by setting, from the smallest
    QSize picture;               ///< that the seconds are for
    quint64 counted = 0;         ///< pixels of the small picture
    std::optional<double> knee;  ///< see CostSurvey::knee
    double present = 0;          ///< the value in force when it was measured ...
    double presentSeconds = 0;   ///< ... and POV-Ray's time with it, the same in the strips of all settings
    bool complete = false;       ///< nothing more is to come

    /// The seconds at a value between two marks, evenly in the logarithms; nothing outside of them.
    std::optional<double> secondsAt(double setting, std::size_t finder) const;
    /// The marks at or around a value: two, one twice where it is met, or null outside.
    std::array<const Mark*, 2> around(double setting) const;

    bool operator==(const CostPlot&) const = default;
};

}  // namespace isoscope
