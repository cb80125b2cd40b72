// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/render/camera/antialiasing.h"
#include "core/render/render_plan.h"
#include "core/render/verdict_map.h"
#include "core/scene/scene.h"

namespace isoscope {

/// What to draw; resources (threads, stop requests) are not part of it.
struct RenderRequest {
    std::shared_ptr<const Scene> scene;
    Camera camera;  ///< the view, which may differ from the scene's while orbiting
    int width = 0;
    int height = 0;
    RootFinder rootFinder = RootFinder::lipschitz;
    bool antialias = false;
    Antialiasing antialiasing;  ///< how, if at all
    /// Leaves out background and sky where the camera sees them, through glass too: Image::opacity says how
    /// much. Mirrors still show them.
    bool transparent = false;
    /// Effects that this picture does without.
    StageSet leftOut;
    /// Filled while drawing, by the certified root finder only; of the size of the picture. May be null.
    std::shared_ptr<VerdictMap> verdicts;
};

}  // namespace isoscope
