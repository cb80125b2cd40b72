// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/stages/stage.h"
#include "core/scene/scene.h"

namespace isoscope {

/// Colours all samples as if their rays met nothing; what they do meet paints over it (DirectLight). Sends no
/// rays.
class Background : public Stage {
  public:
    explicit Background(const Scene& scene);

    void run(TileScratch& work, SampleBatch& batch) const override;

  private:
    glm::dvec3 color_;
};

}  // namespace isoscope
