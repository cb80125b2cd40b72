// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/primary_rays.h"

namespace isoscope {

PrimaryRays::PrimaryRays(const RenderRequest& request)
    : camera_(request.camera),
      width_(request.width),
      height_(request.height),
      objects_(*request.scene, [](const SceneObject& object) { return object.visible; }) {}

void PrimaryRays::run(TileWork& work) const {
    SampleBatch& batch = work.batch;
    for (std::size_t i = 0; i < batch.size(); ++i) {
        batch.rays[i] = camera_.ray(batch.places[i].x / width_ - 0.5, 0.5 - batch.places[i].y / height_);
        batch.rays[i].sample = static_cast<std::uint32_t>(i);
    }
    work.context.verdicts = batch.verdicts;
    work.meter(StageKind::primaryRays).rays += batch.size();
    objects_.nearest(batch.rays, work.context, work.gathered, batch.nearest);
    work.context.verdicts = {};
    for (std::size_t i = 0; i < batch.size(); ++i)
        if (batch.verdicts[i] <= Verdict::certifiedMiss)
            batch.verdicts[i] = batch.nearest[i].found ? Verdict::certifiedHit : Verdict::certifiedMiss;
    work.charge(StageKind::primaryRays);
}

}  // namespace isoscope
