// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/light/fog_lookup.h"
#include "core/render/stages/stage.h"
#include "core/scene/scene.h"

namespace isoscope {

/// Dims the light of sources with `media_attenuation` by the scene's fogs, between source and surface.
/// Sends no rays.
class FogOnLight : public LightFilter {
  public:
    /// The scene must outlive the stage.
    explicit FogOnLight(const Scene& scene) : scene_(scene), fogs_(scene) {}

    void filter(TileScratch& work, SurfacePoints& points, std::size_t light) const override;

    /// Whether the scene calls for it.
    static bool concerns(const Scene& scene);

  private:
    const Scene& scene_;
    FogLookup fogs_;
};

}  // namespace isoscope
