// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace isoscope {

/// Which setting of all isosurfaces is varied.
enum class StudiedSetting { accuracy, maxGradient };

}  // namespace isoscope
