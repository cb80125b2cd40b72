// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/light/ray_sender.h"
#include "core/render/stages/stage.h"

namespace isoscope {

/// Sends rays to where surfaces with `reflection` mirror: what they see is added to the samples.
class Reflection : public Stage {
  public:
    /// The scene must outlive the stage.
    explicit Reflection(const Scene& scene);

    void run(TileWork& work, SampleBatch& batch) const override;

  private:
    void mirror(std::size_t point, const Material& material, SampleBatch& batch, TileWork& work) const;

    const Scene& scene_;
    RaySender sender_;
};

}  // namespace isoscope
