// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/render/render_request.h"

namespace isoscope {

/// What the present settings of one isosurface do to a view of it.
struct SurfaceEffects {
    std::uint64_t mistakes = 0;  ///< its pixels that POV-Ray's method loses, gains or finds at a wrong place
    glm::dvec3 place{0};         ///< in the world: the mistake nearest to the middle of all; if there is one
    double alongRays = 0;        ///< steepest slope that POV-Ray's method met in it
};

/// The same for all isosurfaces of a scene.
struct SettingEffects {
    std::vector<SurfaceEffects> surfaces;
    std::uint64_t pixels = 0;       ///< of the view
    std::uint64_t evaluations = 0;  ///< of POV-Ray's method in the view: a measure of its time
    bool complete = false;
};

/// Traces `view`, which should be small, with both root finders; its own is ignored. A mistake counts for the
/// isosurfaces on which the wrong hit, or the missing one, lies.
SettingEffects settingEffects(RenderRequest view, int threads = 0, std::stop_token stop = {});

/// How many times as many evaluations POV-Ray's method makes in `view` with the present max_gradient of an
/// isosurface as with another one. `evaluations` is SettingEffects' count. Nothing when stopped.
std::optional<double> costBeside(RenderRequest view, std::size_t isosurface, double maxGradient,
                                 std::uint64_t evaluations, int threads = 0, std::stop_token stop = {});

}  // namespace isoscope
