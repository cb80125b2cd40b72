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
    : camera_(request.camera),
      width_(request.width),
      height_(request.height),
      objects_(*request.scene, [](const SceneObject& object) { return object.visible; }) {}

void PrimaryRays::run(TileWork& work) const {
    SampleBatch& batch = work.batch;
    makeRays(batch);
    batch.nearest.resize(batch.rays.size());
    work.context.verdicts = batch.verdicts;
    work.meter(StageKind::primaryRays).rays += batch.size();
    objects_.nearest(batch.rays, work.context, work.gathered, batch.nearest);
    work.context.verdicts = {};
    batch.points.gather(batch.rays, batch.nearest);
    for (const std::uint32_t sample : batch.points.samples)
        if (batch.verdicts[sample] <= Verdict::certifiedMiss) batch.verdicts[sample] = Verdict::certifiedHit;
    work.charge(StageKind::primaryRays);
}

void PrimaryRays::makeRays(SampleBatch& batch) const {
    const std::span<const SampleBatch::Place> places(batch.places);
    if (!objects_.mayMeet(bundle(places))) return;
    for (std::size_t first = 0; first < places.size(); first += blockSamples) {
        const std::size_t count = std::min(blockSamples, places.size() - first);
        if (!objects_.mayMeet(bundle(places.subspan(first, count)))) continue;
        for (std::size_t i = first; i < first + count; ++i) {
            batch.rays.push_back(camera_.ray(places[i].x / width_ - 0.5, 0.5 - places[i].y / height_));
            batch.rays.back().sample = static_cast<std::uint32_t>(i);
        }
    }
}

RayBundle PrimaryRays::bundle(std::span<const SampleBatch::Place> places) const {
    SampleBatch::Place low = places.front(), high = low;
    for (const SampleBatch::Place& place : places) {
        low = {std::min(low.x, place.x), std::min(low.y, place.y)};
        high = {std::max(high.x, place.x), std::max(high.y, place.y)};
    }
    return camera_.bundle(low.x / width_ - 0.5, high.x / width_ - 0.5, 0.5 - high.y / height_,
                          0.5 - low.y / height_);
}

}  // namespace isoscope
