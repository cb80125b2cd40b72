// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/render/light/media_march.h"
#include "core/render/light/object_tracer.h"
#include "core/render/stages/stage.h"

namespace isoscope {

class Textures;

/// Tints the light that comes through transparent objects: by the `filter` and `transmit` of each surface,
/// by interiors that fade or are filled with media, and by `caustics`. The light goes straight, as in
/// POV-Ray. One ray for each place that the light would brighten, and one more for each surface on the way.
class ClearShadows : public LightFilter {
  public:
    /// The scene must outlive the stage. Without `textures` patterned surfaces are opaque; media count
    /// where `media`.
    ClearShadows(const Scene& scene, const Textures* textures, bool media);

    void filter(TileScratch& work, SurfacePoints& points, std::size_t light) const override;

    /// Whether the object is left to this stage.
    static bool concerns(const SceneObject& object) { return object.castsShadow && object.transparent; }

  private:
    struct Beams;

    void findSurfaces(TileScratch& work, Beams& beams) const;
    /// What the surface at point k of `beams.points` lets through.
    glm::dvec3 passing(const Beams& beams, std::size_t k) const;
    void dimByMedia(TileScratch& work, Beams& beams, SurfacePoints& points) const;
    void goOn(Beams& beams) const;

    const Scene& scene_;
    const Textures* textures_;
    ObjectTracer objects_;
    std::optional<MediaMarch> media_;
};

}  // namespace isoscope
