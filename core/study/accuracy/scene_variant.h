// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "core/scene/scene.h"

namespace isoscope {

/// Changes the settings of one isosurface; told which it is.
using SettingsChange = std::function<void(const Isosurface& original, IsosurfaceSettings& settings)>;

/// The scene with other settings for its isosurfaces: `change` is called for each.
/// Everything else is shared with the original.
std::shared_ptr<const Scene> sceneVariant(const Scene& scene, const SettingsChange& change);

}  // namespace isoscope
