// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/camera/camera_rays.h"
#include "core/render/light/object_tracer.h"
#include "core/render/render_request.h"
#include "core/render/stages/stage.h"

namespace isoscope {

/// Sends a ray from the camera through every sample and finds what it meets first. Samples whose neighbours
/// all look past every object are left out together, before they have rays.
class PrimaryRays : public Stage {
  public:
    explicit PrimaryRays(const RenderRequest& request);

    void run(TileScratch& work, SampleBatch& batch) const override;
    /// The same without batch.points, and without the verdicts of those that meet something.
    void find(TileScratch& work, SampleBatch& batch) const;

    /// Whether a ray through this part of the picture may meet an object.
    bool mayMeet(const SampleBatch::Extent& extent) const {
        return objects_.mayMeet(cameraRays_.bundle(extent));
    }

  private:
    void search(TileScratch& work, SampleBatch& batch) const;
    void lookPastNearest(TileScratch& work, SampleBatch& batch) const;
    bool cornersMayMeet(std::span<const SampleBatch::PixelPosition> places) const;
    void makeRays(SampleBatch& batch) const;

    CameraRays cameraRays_;
    ObjectTracer objects_;
};

}  // namespace isoscope
