// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/stages/stage.h"
#include "core/scene/scene.h"

namespace isoscope {

/// Takes away the light of sources with `projected_through` that does not come through their object. What
/// lies beyond the object casts no shadow: SurfacePoints::distance ends there. One ray for each
/// place that such a light would brighten.
class Projection : public LightFilter {
  public:
    /// The scene must outlive the stage.
    explicit Projection(const Scene& scene) : scene_(scene) {}

    void filter(TileScratch& work, SurfacePoints& points, std::size_t light) const override;

  private:
    const Scene& scene_;
};

}  // namespace isoscope
