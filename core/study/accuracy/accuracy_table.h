// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/study/accuracy/accuracy_study.h"

namespace isoscope {

/// The points of a study as CSV lines, numbers with 17 significant digits.
std::string accuracyTableHeader(StudiedSetting setting);
std::string accuracyTableLine(const AccuracyPoint& point);

}  // namespace isoscope
