// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/scene/scene.h"

namespace isoscope {

/// A complete scene that POV-Ray 3.7 renders to the picture of `scene` seen by `camera`: the user's text,
/// kept as it is, with version, camera and what else is missing put around it.
std::string exportScene(const Scene& scene, const Camera& camera, const std::string& text, int width,
                        int height);

/// The isosurface statement number `index` with the declarations it needs, as an include file. Empty for a
/// wrong index.
std::string exportIsosurface(const Scene& scene, std::size_t index, const std::string& text);

/// A `camera { ... }` block that sets this view in POV-Ray.
std::string cameraBlock(const Camera& camera);

}  // namespace isoscope
