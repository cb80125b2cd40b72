// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/render/camera/pixel.h"
#include "core/render/light/lighting.h"
#include "core/render/render_plan.h"
#include "core/roots/verdict.h"
#include "core/shapes/rays/hit_batch.h"
#include "core/shapes/rays/ray_batch.h"

namespace isoscope {

/// A material under all the lights of a scene.
struct SimpleSurface {
    glm::dvec3 shine{0};  ///< without any light
    std::vector<Lighting> lightings;
    bool matte = false;  ///< returns light as Lambert says, and nothing else
};

/// Paints what rays have met in scenes where its normal and its material alone decide how it looks: lights
/// shine evenly from points and nothing stands in their way, no material has a pattern or lets anything
/// through. That takes but one pass from hits to pixels; DirectLight, which serves all scenes, has to write
/// down for each light what other stages may ask for, which is a good part of a simple picture's time.
class SimpleShading {
  public:
    /// Nothing for scenes that are not so plain.
    static std::optional<SimpleShading> of(const Scene& scene, const RenderPlan& plan);

    /// Gives the pixels, by the samples of the rays, the colours that DirectLight would give them, clipped to
    /// [0, 1] but still in the colour space of the scene. Those that have met nothing stay. The verdicts of
    /// the others become hits, unless less is certain.
    void paint(const RayBatch& rays, const HitBatch& hits, std::span<LinearColor> pixels,
               std::span<Verdict> verdicts) const;

  private:
    SimpleShading() = default;

    std::vector<glm::dvec3> lights_;
    std::vector<SimpleSurface> surfaces_;  ///< of every material, and at last where there is none
};

}  // namespace isoscope
