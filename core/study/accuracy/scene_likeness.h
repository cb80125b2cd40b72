// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"
#include "core/study/accuracy/studied_setting.h"

namespace isoscope {

/// Whether two scenes have the same isosurfaces but for this setting, so that what was measured over it for
/// one holds for the other. Functions count as the same when their tapes and the numbers in them are. Other
/// objects, lights and materials are only counted.
bool sameButFor(StudiedSetting setting, const Scene& a, const Scene& b);

}  // namespace isoscope
