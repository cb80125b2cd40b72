// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/render/stages/stage.h"
#include "core/scene/scene.h"

namespace isoscope {

class AreaLightWork;

/// Soft shadows of area lights: every light of the grid is asked for its shadow like a light of its own, and
/// the surface gets the mean. The grid is divided like POV-Ray's, from its corners inwards: where `adaptive`
/// says so, only as long as corners differ, so that rays go where the penumbra is. Lights without an area are
/// left to the shadows of points.
///
/// Jitter is at random but depends on the place alone, so that the same picture comes out however it is
/// divided among threads.
class AreaLights : public LightFilter {
  public:
    /// `shadows` are those of lights that are points; the scene must outlive the stage.
    AreaLights(const Scene& scene, std::unique_ptr<LightFilter> shadows);

    void filter(TileScratch& work, SurfacePoints& points, std::size_t light) const override;

  private:
    /// Asks for the light from all wanted places.
    void ask(std::size_t number, TileScratch& work, AreaLightWork& own) const;
    void askAll(const LightSource& light, const SurfacePoints& points, std::size_t number, TileScratch& work,
                AreaLightWork& own) const;

    const Scene& scene_;
    std::unique_ptr<LightFilter> shadows_;
};

}  // namespace isoscope
