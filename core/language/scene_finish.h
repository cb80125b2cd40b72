// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/language/scene_draft.h"

namespace isoscope {

/// What is done when a text has been read, in any notation: shapes are made of its objects, or of the one
/// declared last where it shows none; settings and sliders go to the scene; a camera and a light are added
/// where there is none.
void finishScene(SceneDraft& draft, ParseContext& context);

}  // namespace isoscope
