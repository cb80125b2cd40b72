// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/primary_rays.h"

#include <algorithm>

#include "core/render/effect_reasons.h"
#include "core/render/light/secondary_rays.h"
#include "core/render/picture_parts.h"

namespace isoscope {

namespace {

/// Of these many samples that follow each other the bundle of rays is tried; in a picture drawn in squares
/// they are 8 x 8.
constexpr std::size_t blockSamples = 64;

}  // namespace

PrimaryRays::PrimaryRays(const RenderRequest& request)
    : cameraRays_(request.camera, request.width, request.height),
      objects_(*request.scene, [](const SceneObject& object) { return object.visible; }) {}

void PrimaryRays::run(TileScratch& work, SampleBatch& batch) const {
    search(work, batch);
    if (!batch.rays.empty()) batch.points.makeRoom(batch.size());
    batch.points.gather(batch.rays, batch.hits);
    for (const std::uint32_t sample : batch.points.samples)
        if (batch.verdicts[sample] <= Verdict::certifiedMiss) batch.verdicts[sample] = Verdict::certifiedHit;
    work.charge(StageKind::primaryRays);
}

void PrimaryRays::find(TileScratch& work, SampleBatch& batch) const {
    search(work, batch);
    work.charge(StageKind::primaryRays);
}

void PrimaryRays::search(TileScratch& work, SampleBatch& batch) const {
    makeRays(batch);
    if (!batch.rays.empty()) batch.hits.reserve(batch.size());
    work.context.verdicts = batch.verdicts;
    work.meter(StageKind::primaryRays).rays += batch.size();
    objects_.nearest(batch.rays, work.context, work.gathered, batch.hits);
    lookPastNearest(work, batch);
    work.context.verdicts = {};
}

/// As in POV-Ray, no camera sees what it touches.
void PrimaryRays::lookPastNearest(TileScratch& work, SampleBatch& batch) const {
    const std::span<const double> places(batch.hits[HitBatch::t], batch.rays.size());
    const auto tooNear = [](double t) { return t < SecondaryRays::startTolerance; };
    if (std::ranges::none_of(places, tooNear)) return;
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < places.size(); ++i)
        if (tooNear(places[i])) numbers.push_back(i);
    for (const std::uint32_t i : numbers) batch.hits.limit(i, HitBatch::never);
    RayBatch rays;
    rays.gather(batch.rays, numbers);
    HitBatch hits;
    work.context.nearLimit = SecondaryRays::startTolerance;
    objects_.nearest(rays, work.context, work.gathered, hits);
    work.context.nearLimit = 0;
    batch.hits.takeNearer(hits, numbers);
}

/// Whether the first and the last block of the first and of the last quarter may meet something: in a square
/// of 4 x 4 blocks, those in its corners.
bool PrimaryRays::cornersMayMeet(std::span<const SampleBatch::PixelPosition> places) const {
    const std::size_t blocks = places.size() / blockSamples;
    if (blocks < 8) return false;
    for (const std::size_t block : {std::size_t{0}, blocks / 4 - 1, blocks - blocks / 4, blocks - 1})
        if (!mayMeet(CameraRays::extent(places.subspan(block * blockSamples, blockSamples)))) return false;
    return true;
}

void PrimaryRays::makeRays(SampleBatch& batch) const {
    const std::span<const SampleBatch::PixelPosition> places(batch.places);
    // Blocks between them mostly may as well: to ask each of them takes as long as to find that out from rays
    // of the few that may not.
    if (objects_.size() == 1 && cornersMayMeet(places)) {
        cameraRays_.append(places, 0, batch.rays);
    } else {
        if (places.empty() || !mayMeet(CameraRays::extent(places))) return;
        batch.rays.reserve(places.size());
        for (std::size_t first = 0; first < places.size(); first += blockSamples) {
            const auto block = places.subspan(first, std::min(blockSamples, places.size() - first));
            if (mayMeet(CameraRays::extent(block))) cameraRays_.append(block, first, batch.rays);
        }
    }
    cameraRays_.spread(batch.lens, batch.rays);
    cameraRays_.dropBlind(batch.rays);
}

namespace {

EffectReason reasonFor(const Scene& scene) {
    const std::size_t visible = countObjects(scene, &SceneObject::visible);
    if (visible == 0) return {false, "there is no visible object"};
    return {true, counted(visible, "visible object")};
}

void build(PictureParts& parts) { parts.primaryRays = std::make_unique<PrimaryRays>(parts.request); }

}  // namespace

const EffectDescription effects::primaryRays{
    .name = "primary rays", .reasonFor = reasonFor, .build = build, .canBeLeftOut = false};

}  // namespace isoscope
