// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/scene/scene.h"

namespace isoscope {

/// Makes the tapes of Scene::materials, one for all materials with the same pigment, normal or map, and adds
/// the parts of layered and mapped ones as materials of their own. A pigment that turns out to be the same
/// everywhere becomes a colour. What is too large for a function is left out (a pigment becomes grey): false
/// then. `others` are materials without parts that stand elsewhere in the scene.
bool compileMaterials(Scene& scene, std::span<Material* const> others);

}  // namespace isoscope
