// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/scene/scene.h"

namespace isoscope {

/// A complete scene that POV-Ray 3.7 renders to the picture of `scene` seen by `camera`, at width x height as
/// at any other size: the user's text, kept as it is, with what is missing put around it. `#version 3.7;`
/// goes before a text without version; a view that differs replaces the camera block; a camera or light that
/// the parser added is written at the end.
std::string exportScene(const Scene& scene, const Camera& camera, const std::string& text, int width,
                        int height);

/// A `camera { ... }` block that sets this view in POV-Ray: by look_at where that makes the same view, else
/// by its axes.
std::string cameraBlock(const Camera& camera);

}  // namespace isoscope
