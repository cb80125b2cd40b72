// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/render_request.h"
#include "core/render/stages/stage.h"

namespace isoscope {

/// Paints black what lies around the round picture of a fisheye or omnimax camera, as POV-Ray does: no sky
/// and no background is seen there. Sends no rays.
class Surround : public Stage {
  public:
    explicit Surround(const RenderRequest& request);

    void run(TileScratch& work, SampleBatch& batch) const override;

  private:
    Camera camera_;
    double width_;
    double height_;
};

}  // namespace isoscope
