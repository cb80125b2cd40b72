// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>

#include "core/study/accuracy/accuracy_study.h"

namespace isoscope {

/// The ends of a range of values, from the coarse to the fine one: `from` may be the greater.
struct SettingRange {
    double from = 0;
    double to = 0;
};

/// The values worth studying. accuracy: from 1e-1 to 1e-9. max_gradient: from a tenth to ten times the
/// largest proven bound of the scene's isosurfaces; of their largest setting where nothing is proven.
SettingRange studiedRange(const Scene& scene, StudiedSetting setting, std::stop_token stop = {});

/// The study of `view` with `count` values over the studied range, coarse first, three runs each, in a
/// picture so small that it takes about `cpuSeconds`. The costs are guessed from a picture of 24 pixels
/// across with the ends of the range. One thread does it, so that others have the rest of the machine.
/// Stopped early, the request has no values.
AccuracyStudyRequest planAccuracyStudy(RenderRequest view, StudiedSetting setting, int count,
                                       double cpuSeconds, std::stop_token stop = {});

}  // namespace isoscope
