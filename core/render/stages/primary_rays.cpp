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

void PrimaryRays::run(TileWork& work, SampleBatch& batch) const {
    search(work, batch);
    if (!batch.rays.empty()) batch.points.makeRoom(batch.size());
    batch.points.gather(batch.rays, batch.hits);
    for (const std::uint32_t sample : batch.points.samples)
        if (batch.verdicts[sample] <= Verdict::certifiedMiss) batch.verdicts[sample] = Verdict::certifiedHit;
    work.charge(StageKind::primaryRays);
}

void PrimaryRays::find(TileWork& work, SampleBatch& batch) const {
    search(work, batch);
    work.charge(StageKind::primaryRays);
}

void PrimaryRays::search(TileWork& work, SampleBatch& batch) const {
    makeRays(batch);
    if (!batch.rays.empty()) batch.hits.reserve(batch.size());
    work.context.verdicts = batch.verdicts;
    work.meter(StageKind::primaryRays).rays += batch.size();
    objects_.nearest(batch.rays, work.context, work.gathered, batch.hits);
    work.context.verdicts = {};
}

void PrimaryRays::makeRays(SampleBatch& batch) const {
    const std::span<const SampleBatch::Place> places(batch.places);
    if (places.empty()) return;
    const auto block = [&](std::size_t first) {
        return places.subspan(first, std::min(blockSamples, places.size() - first));
    };
    batch.extents.clear();
    for (std::size_t first = 0; first < places.size(); first += blockSamples)
        batch.extents.push_back(CameraRays::extent(block(first)));
    SampleBatch::Extent whole = batch.extents.front();
    for (const SampleBatch::Extent& extent : batch.extents) whole.add(extent);
    if (!mayMeet(whole)) return;
    batch.rays.reserve(places.size());
    for (std::size_t k = 0; k < batch.extents.size(); ++k)
        if (mayMeet(batch.extents[k]))
            cameraRays_.append(block(k * blockSamples), k * blockSamples, batch.rays);
    cameraRays_.spread(batch.lens, batch.rays);
    cameraRays_.dropBlind(batch.rays);
}

}  // namespace isoscope
