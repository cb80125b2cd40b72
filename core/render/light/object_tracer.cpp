// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/light/object_tracer.h"

#include <algorithm>
#include <cstdint>

namespace isoscope {

void ObjectTracer::buildBvh() {
    std::vector<Bounds> boxes;
    for (const Entry& entry : objects_) boxes.push_back(entry.bounds);
    tree_ = Bvh(boxes);
}

bool ObjectTracer::mayMeet(const RayBundle& rays) const {
    if (!tree_.empty())
        return tree_.any([&](const Bounds& branch) { return rays.mayMeet(branch); },
                         [&](std::size_t object) { return objects_[object].mayMeet(rays); });
    return std::any_of(objects_.begin(), objects_.end(),
                       [&](const Entry& entry) { return entry.mayMeet(rays); });
}

template <class Ask>
void ObjectTracer::forEachMet(const RayBatch& rays, const HitBatch& known, GatheredRays& asked,
                              Ask ask) const {
    asked.slabs.assign(rays);
    const RayBundle& bundle = asked.slabs.bundle();
    const double* const farthest = known[HitBatch::t];
    if (tree_.empty()) {
        for (const Entry& entry : objects_) {
            if (!entry.mayMeet(bundle)) continue;
            asked.slabs.findMeeting(entry.bounds, farthest, asked.meeting);
            if (!asked.meeting.empty()) ask(entry);
        }
        return;
    }
    asked.candidates.clear();
    asked.candidateRays.clear();
    tree_.visitMany(
        rays.size(), asked.slabs, asked.walk, [&](const Bounds& branch) { return bundle.mayMeet(branch); },
        [&](std::size_t object, std::span<const std::uint32_t> numbers) {
            asked.candidates.push_back({static_cast<std::uint32_t>(object),
                                        static_cast<std::uint32_t>(asked.candidateRays.size()),
                                        static_cast<std::uint32_t>(numbers.size())});
            asked.candidateRays.insert(asked.candidateRays.end(), numbers.begin(), numbers.end());
        });
    std::sort(asked.candidates.begin(), asked.candidates.end(),
              [](const auto& one, const auto& other) { return one.object < other.object; });
    for (const GatheredRays::Candidate& candidate : asked.candidates) {
        const Entry& entry = objects_[candidate.object];
        if (!entry.mayMeet(bundle)) continue;
        asked.meeting.resize(candidate.count);
        asked.meeting.resize(asked.slabs.keepMeeting(entry.bounds, farthest,
                                                     asked.candidateRays.data() + candidate.first,
                                                     candidate.count, asked.meeting.data()));
        if (!asked.meeting.empty()) ask(entry);
    }
}

void ObjectTracer::nearest(std::span<const Ray> rays, TraceContext& context, GatheredRays& asked,
                           std::span<NearestHit> nearest) const {
    asked.all.assign(rays);
    HitBatch hits;
    this->nearest(asked.all, context, asked, hits);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const double t = hits[HitBatch::t][i];
        nearest[i].found = hits.found(i);
        if (hits.found(i))
            nearest[i].hit = {t, rays[i].at(t), hits.normal(i), hits.material(i), hits.kind(i)};
    }
}

void ObjectTracer::nearest(const RayBatch& rays, TraceContext& context, GatheredRays& asked,
                           HitBatch& hits) const {
    hits.reset(rays.size());
    if (rays.empty()) return;
    // The only object of a scene finds out by itself which rays come near it.
    if (objects_.size() == 1 && !boundsCut_) {
        objects_[0].object->shape->nearestInBatch(rays, context, hits);
        hits.setMaterial(objects_[0].object->material);
        return;
    }
    forEachMet(rays, hits, asked, [&](const Entry& entry) {
        // The hits of the objects before have their materials.
        if (allHaveMaterials_ && asked.meeting.size() == rays.size()) {
            entry.object->shape->nearestInBatch(rays, context, hits);
            hits.setMaterial(entry.object->material);
            return;
        }
        asked.gather(rays, hits);
        entry.object->shape->nearestInBatch(asked.rays, context, asked.hits);
        asked.hits.setMaterial(entry.object->material);
        hits.takeNearer(asked.hits, asked.meeting);
    });
}

void ObjectTracer::blocked(std::span<const Ray> rays, std::span<const double> limits, TraceContext& context,
                           GatheredRays& asked, std::span<std::uint8_t> blocked) const {
    std::fill(blocked.begin(), blocked.end(), 0);
    if (rays.empty()) return;
    asked.all.assign(rays);
    asked.known.reset(rays.size());
    // A hit at the light is given beforehand: only nearer ones replace it.
    for (std::size_t i = 0; i < rays.size(); ++i) asked.known.limit(i, limits[i]);
    const auto block = [&](std::size_t i) {
        blocked[i] = 1;
        // Others need not be asked about it.
        asked.known.limit(i, -1);
    };
    const auto askAll = [&](const Entry& entry) {
        entry.object->shape->nearestInBatch(asked.all, context, asked.known);
        for (std::size_t i = 0; i < rays.size(); ++i)
            if (asked.known[HitBatch::t][i] < limits[i]) block(i);
    };
    // The only object finds out by itself which of them come near it.
    if (objects_.size() == 1 && !boundsCut_) {
        if (objects_[0].mayMeet(RayBundle(rays))) askAll(objects_[0]);
        return;
    }
    forEachMet(asked.all, asked.known, asked, [&](const Entry& entry) {
        if (asked.meeting.size() == rays.size()) return askAll(entry);
        asked.gather(asked.all, asked.known);
        entry.object->shape->nearestInBatch(asked.rays, context, asked.hits);
        for (std::size_t k = 0; k < asked.meeting.size(); ++k)
            if (asked.hits[HitBatch::t][k] < limits[asked.meeting[k]]) block(asked.meeting[k]);
    });
}

}  // namespace isoscope
