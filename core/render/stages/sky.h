// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/light/sight_rays.h"
#include "core/render/stages/stage.h"

namespace isoscope {

/// Paints the samples whose rays have met nothing with the sky_sphere of the scene, over the background.
class Sky : public Stage {
  public:
    /// The request's scene has a sky and must outlive the stage.
    explicit Sky(const RenderRequest& request);

    void run(TileScratch& work, SampleBatch& batch) const override;

  private:
    const SkySphere& sky_;
    glm::dvec3 background_;
    SightRays sightRays_;
};

}  // namespace isoscope
