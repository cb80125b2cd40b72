// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "core/scene/scene.h"

namespace isoscope {

/// The scene with other settings for its isosurfaces: `change` is called with the settings of each.
/// Everything else is shared with the original.
std::shared_ptr<const Scene> sceneVariant(const Scene& scene,
                                          const std::function<void(IsosurfaceSettings&)>& change);

}  // namespace isoscope
