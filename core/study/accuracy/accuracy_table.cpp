// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/accuracy/accuracy_table.h"

#include "core/text/csv_table.h"
#include "core/text/number_format.h"

namespace isoscope {

std::string accuracyTableHeader(StudiedSetting setting) {
    return csvLine({"solver", setting == StudiedSetting::maxGradient ? "max_gradient" : "accuracy",
                    "cpu_seconds", "evaluations", "evaluations_per_pixel", "missed", "gained", "wrong_place",
                    "worst_error", "mean_error", "changed"});
}

std::string accuracyTableLine(const AccuracyPoint& point) {
    return csvLine({point.finder == RootFinder::lipschitz ? "lipschitz" : "certified",
                    exactNumber(point.setting), exactNumber(point.cpuSeconds),
                    std::to_string(point.evaluations), exactNumber(point.evaluationsPerPixel),
                    std::to_string(point.lost), std::to_string(point.gained),
                    std::to_string(point.wrongPlace), exactNumber(point.worstError),
                    exactNumber(point.meanError), std::to_string(point.changed)});
}

}  // namespace isoscope
