// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/light/sight_rays.h"
#include "core/render/stages/stage.h"

namespace isoscope {

/// Lays the scene's rainbows over what the rays see, and dims what later rays will add
/// (SampleBatch::through). Measured on POV-Ray 3.7: what lies behind comes through by the colour's
/// `transmit`, or by exp(-length of the ray / distance) where that is more. Sends no rays.
class RainbowStage : public Stage {
  public:
    /// The request's scene must outlive the stage.
    explicit RainbowStage(const RenderRequest& request);

    void run(TileScratch& work, SampleBatch& batch) const override;

  private:
    class Work;

    const Scene& scene_;
    SightRays sightRays_;
};

/// Where a line of sight meets a rainbow: 0 at its inner edge and 1 at its outer one, and how strongly it
/// shows there, 0 outside of it.
struct RainbowPlace {
    double across = 0;
    double strength = 0;
};
/// `sight` is the direction of unit length. Jitter follows from the direction alone, so that a picture is the
/// same on every run.
RainbowPlace placeIn(const Rainbow& rainbow, const glm::dvec3& sight);

}  // namespace isoscope
