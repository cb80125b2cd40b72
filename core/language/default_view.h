// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/language/scene_draft.h"

namespace isoscope {

/// Gives a text without a camera one that looks at all finite objects from the front, a little from the right
/// and above, and a text without a light one at the camera, so that an isosurface on its own can be seen;
/// not where surfaces shine by themselves (emission, much ambient). Says so in notes. Call it when the
/// objects of the scene are built.
void addDefaultView(SceneDraft& draft, ParseContext& context);

}  // namespace isoscope
