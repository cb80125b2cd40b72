// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/scene/camera.h"
#include "core/study/view/surface_bounds.h"

namespace isoscope {

/// How much of the picture's width or height, the scarcer of the two, what is fitted usually takes.
constexpr double fittedShare = 0.7;

/// `camera` moved, without turning, to where it shows all of the surfaces, in the middle and as large as
/// `share` allows; it then looks at the middle of their depth. `seen` is the camera that draws the
/// picture: the same, but for a picture that was widened or heightened to the window's proportions.
/// Orthographic cameras are narrowed or widened as well; those with a curved picture step back to where they
/// see a ball around everything. Nothing when nothing is shown, or when all that is there has no end.
std::optional<Camera> fittedView(const Camera& camera, const Camera& seen, SurfaceBounds& surfaces,
                                 double share = fittedShare);

/// `camera` turned half way from its own direction to the one in which `box` shows most of itself, from the
/// same side: flat things are looked at from above, slim ones from the side. The location stays.
Camera turnedToFace(const Camera& camera, const Bounds& box);

/// Where a standard view looks from.
enum class StandardView { front, top, side };

/// `camera` turned to look along an axis: from the front, from above with what is behind at the top of the
/// picture, or from the right. Up is the axis that its `sky` is nearest to. The location stays.
Camera turnedTo(const Camera& camera, StandardView view);

}  // namespace isoscope
