// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/primary_rays.h"

#include <algorithm>

namespace isoscope {

namespace {

/// Of these many samples that follow each other the bundle of rays is tried; in a picture drawn in squares
/// they are 8 x 8.
constexpr std::size_t blockSamples = 64;

}  // namespace

PrimaryRays::PrimaryRays(const RenderRequest& request)
    : cameraRays_(request.camera, request.width, request.height),
      objects_(*request.scene, [](const SceneObject& object) { return object.visible; }) {}

void PrimaryRays::run(TileWork& work) const {
    SampleBatch& batch = work.batch;
    makeRays(batch);
    work.context.verdicts = batch.verdicts;
    work.meter(StageKind::primaryRays).rays += batch.size();
    objects_.nearest(batch.rays, work.context, work.gathered, batch.hits);
    work.context.verdicts = {};
    batch.points.gather(batch.rays, batch.hits);
    for (const std::uint32_t sample : batch.points.samples)
        if (batch.verdicts[sample] <= Verdict::certifiedMiss) batch.verdicts[sample] = Verdict::certifiedHit;
    work.charge(StageKind::primaryRays);
}

void PrimaryRays::makeRays(SampleBatch& batch) const {
    const std::span<const SampleBatch::Place> places(batch.places);
    if (!objects_.mayMeet(cameraRays_.bundle(places))) return;
    for (std::size_t first = 0; first < places.size(); first += blockSamples) {
        const std::size_t count = std::min(blockSamples, places.size() - first);
        const std::span<const SampleBatch::Place> block = places.subspan(first, count);
        if (!objects_.mayMeet(cameraRays_.bundle(block))) continue;
        cameraRays_.append(block, first, batch.rays);
    }
}

}  // namespace isoscope
