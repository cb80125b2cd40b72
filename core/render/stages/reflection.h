// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/light/secondary_ray_queue.h"
#include "core/render/stages/stage.h"

namespace isoscope {

/// Sends rays to where surfaces with `reflection` mirror: what they see is added to the samples.
class Reflection : public Stage {
  public:
    /// The scene must outlive the stage.
    explicit Reflection(const Scene& scene);

    void run(TileScratch& work, SampleBatch& batch) const override;

  private:
    void mirror(std::size_t point, const Material& material, SampleBatch& batch, TileScratch& work) const;

    const Scene& scene_;
    SecondaryRayQueue sender_;
};

}  // namespace isoscope
