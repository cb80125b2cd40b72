// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/camera/camera_rays.h"
#include "core/render/render_request.h"

namespace isoscope {

/// The rays of all samples of a batch, those too that were left out because they meet nothing: for stages
/// that paint what lies behind everything, or in between. They are made at the first call for a batch.
class SightRays {
  public:
    explicit SightRays(const RenderRequest& request)
        : cameraRays_(request.camera, request.width, request.height) {}

    /// Ray i belongs to sample i.
    const RayBatch& of(SampleBatch& batch) const {
        if (!batch.fromCamera() || batch.rays.size() == batch.size()) return batch.rays;
        if (batch.sight.empty()) {
            cameraRays_.append(batch.places, 0, batch.sight);
            cameraRays_.spread(batch.lens, batch.sight);
        }
        return batch.sight;
    }

  private:
    CameraRays cameraRays_;
};

}  // namespace isoscope
