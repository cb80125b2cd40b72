// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/light/secondary_ray_queue.h"
#include "core/render/stages/stage.h"

namespace isoscope {

/// Sends rays on through surfaces that let light through (`filter`, `transmit`), bent where the ior changes
/// when refraction is planned, and weakened by the interiors they leave (`fade_distance`). Where an interior
/// lets none out, the ray is mirrored instead: SampleBatch::mirrored tells Reflection.
class Transparency : public Stage {
  public:
    /// The scene must outlive the stage.
    Transparency(const Scene& scene, bool refraction);

    void run(TileScratch& work, SampleBatch& batch) const override;

  private:
    /// A surface as a ray meets it: one point, or several that are layers and parts of one texture.
    struct Surface {
        std::size_t first = 0;  ///< the outermost layer, whose normal counts
        glm::dvec3 transmission{0};
    };
    const Material* materialOf(const SurfacePoints& points, std::size_t k) const;
    /// What comes through at point k, reflection that takes from it counted.
    glm::dvec3 transmissionOf(const SampleBatch& batch, std::size_t k) const;
    void send(const Surface& surface, SampleBatch& batch, TileScratch& work) const;
    /// One ray for each colour that the interior takes white light apart into.
    void sendSpectrum(const Surface& surface, const LightPath& path, const SecondaryRayRequest& white,
                      SampleBatch& batch, TileScratch& work) const;
    /// `glance` is what would go straight on, undiminished by the surface.
    void sendBent(const Surface& surface, const LightPath& path, SecondaryRayRequest glance,
                  SampleBatch& batch, TileScratch& work) const;

    const Scene& scene_;
    SecondaryRayQueue sender_;
    bool refraction_;
};

}  // namespace isoscope
