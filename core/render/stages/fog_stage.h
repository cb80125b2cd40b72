// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/light/fog_lookup.h"
#include "core/render/light/sight_rays.h"
#include "core/render/stages/stage.h"

namespace isoscope {

/// Lays the scene's fogs over what the rays see, background and sky included, and dims what later rays will
/// add (SampleBatch::through). Inside of objects that are not hollow there is no fog. Sends no rays.
class FogStage : public Stage {
  public:
    /// The request's scene must outlive the stage.
    explicit FogStage(const RenderRequest& request);

    void run(TileScratch& work, SampleBatch& batch) const override;

  private:
    bool reaches(const InteriorList& inside) const;
    /// Lays all fogs over what is seen on a way.
    void lay(std::size_t way, std::uint32_t sample, const FogLookup::Work& own, SampleBatch& batch) const;

    const Scene& scene_;
    FogLookup fogs_;
    SightRays sightRays_;
};

}  // namespace isoscope
