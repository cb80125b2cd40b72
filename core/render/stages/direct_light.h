// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/render/stages/filter_chain.h"
#include "core/render/stages/stage.h"
#include "core/scene/scene.h"

namespace isoscope {

/// What surfaces shine by themselves (ambient, emission) and what they return of the light that falls on them
/// straight from a light source: it paints the samples of the batch's points. Filters, if any, are asked
/// about each light in turn. Sends no rays itself.
class DirectLight : public Stage {
  public:
    /// Which of the stages that it works with are planned.
    struct Shown {
        bool textures = true;      ///< without it patterned materials are evenly grey and smooth
        bool transparency = true;  ///< without it all materials are opaque
        bool areas = true;         ///< without it all light comes from points
    };

    /// The scene must outlive the stage. Filters may be added until it runs.
    DirectLight(const Scene& scene, std::shared_ptr<const LightFilters> filters, const Shown& shown);

    void run(TileScratch& work, SampleBatch& batch) const override;

  private:
    const Material& material(MaterialId id) const;
    /// Calls visit(material, range) for each stretch of points with one material, in order.
    template <class Visit>
    void visitMaterials(const SurfacePoints& points, Visit visit) const;
    void ownLight(SurfacePoints& points) const;
    void gatherArea(SurfacePoints& points, std::size_t light) const;
    void gather(SurfacePoints& points, const LightSource& light) const;

    const Scene& scene_;
    std::shared_ptr<const LightFilters> filters_;
    std::vector<Material> materials_;  ///< in place of the scene's, where a stage is left out; else empty
    Material plain_;
    std::vector<std::vector<LightSource>> areas_;  ///< of each light, those of its grid, if it shines from it
    bool grouped_ = false;                         ///< some lights reach some objects only
};

}  // namespace isoscope
