// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/object_tracer.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace isoscope {

namespace {

/// The rays among `numbers` that may meet the box.
void keepMeeting(const Bounds& box, std::span<const std::uint32_t> numbers, GatheredRays& asked) {
    asked.meeting.clear();
    for (const std::uint32_t i : numbers)
        if (asked.walk.slabs[i].mayMeet(box, asked.farthest[i])) asked.meeting.push_back(i);
}

}  // namespace

void ObjectTracer::plantTree() {
    std::vector<Bounds> boxes;
    for (const Entry& entry : objects_) boxes.push_back(entry.bounds);
    tree_ = BoxTree(boxes);
}

bool ObjectTracer::mayMeet(const RayBundle& rays) const {
    if (!tree_.empty())
        return tree_.any([&](const Bounds& branch) { return rays.mayMeet(branch); },
                         [&](std::size_t object) { return objects_[object].mayMeet(rays); });
    return std::any_of(objects_.begin(), objects_.end(),
                       [&](const Entry& entry) { return entry.mayMeet(rays); });
}

template <class Ask>
void ObjectTracer::forEachMet(std::span<const Ray> rays, GatheredRays& asked, Ask ask) const {
    const RayBundle bundle(rays);
    const auto askAbout = [&](const Entry& entry) {
        asked.clear();
        for (const std::uint32_t i : asked.meeting) asked.add(i, rays[i]);
        if (!asked.rays.empty()) ask(entry);
    };
    if (tree_.empty()) {
        asked.slabs.assign(rays);
        for (const Entry& entry : objects_) {
            if (!entry.mayMeet(bundle)) continue;
            asked.slabs.findMeeting(entry.bounds, asked.farthest.data(), asked.meeting);
            askAbout(entry);
        }
        return;
    }
    asked.walk.begin(rays);
    asked.candidates.clear();
    asked.candidateRays.clear();
    tree_.visitMany(
        rays, asked.walk, [&](const Bounds& branch) { return bundle.mayMeet(branch); },
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
        keepMeeting(entry.bounds,
                    std::span(std::as_const(asked.candidateRays)).subspan(candidate.first, candidate.count),
                    asked);
        askAbout(entry);
    }
}

void ObjectTracer::nearest(std::span<const Ray> rays, TraceContext& context, GatheredRays& asked,
                           std::span<NearestHit> nearest) const {
    for (NearestHit& hit : nearest) hit.found = false;
    if (rays.empty()) return;
    // The only object of a scene finds out by itself which rays come near it.
    if (objects_.size() == 1) {
        objects_[0].object->shape->nearest(rays, context, nearest);
        for (NearestHit& hit : nearest)
            if (hit.found) claim(objects_[0], hit);
        return;
    }
    asked.farthest.assign(rays.size() + SlabBatch::padding, RayInterval().far);
    forEachMet(rays, asked, [&](const Entry& entry) {
        entry.object->shape->nearest(asked.rays, context, asked.nearest);
        for (std::size_t k = 0; k < asked.indices.size(); ++k) {
            const std::uint32_t i = asked.indices[k];
            if (!asked.nearest[k].found || !(asked.nearest[k].hit.t < asked.farthest[i])) continue;
            nearest[i] = asked.nearest[k];
            asked.farthest[i] = nearest[i].hit.t;
            claim(entry, nearest[i]);
        }
    });
}

void ObjectTracer::nearest(const RayBatch& rays, TraceContext& context, GatheredRays& asked,
                           HitBatch& hits) const {
    hits.reset(rays.size());
    if (rays.empty()) return;
    if (objects_.size() == 1) {
        objects_[0].object->shape->nearestInBatch(rays, context, hits);
        hits.claim(objects_[0].object->material);
        return;
    }
    // Each object sees only some of the rays: those are gathered one by one.
    std::vector<Ray>& list = asked.all;
    list.clear();
    for (std::size_t i = 0; i < rays.size(); ++i) list.push_back(rays.ray(i));
    asked.allNearest.resize(rays.size());
    nearest(list, context, asked, asked.allNearest);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Hit& hit = asked.allNearest[i].hit;
        if (asked.allNearest[i].found) hits.set(i, hit.t, hit.normal, hit.kind, hit.material);
    }
}

/// The hits of the objects before have their materials.
void ObjectTracer::claim(const Entry& entry, NearestHit& hit) {
    if (hit.hit.material == noMaterial) hit.hit.material = entry.object->material;
}

void ObjectTracer::blocked(std::span<const Ray> rays, std::span<const double> limits, TraceContext& context,
                           GatheredRays& asked, std::span<std::uint8_t> blocked) const {
    std::fill(blocked.begin(), blocked.end(), 0);
    if (rays.empty()) return;
    if (objects_.size() == 1) {
        if (!objects_[0].mayMeet(RayBundle(rays))) return;
        // It finds out by itself which of them come near it.
        asked.addAll(rays, limits);
        objects_[0].object->shape->nearest(asked.rays, context, asked.nearest);
        for (std::size_t i = 0; i < rays.size(); ++i) blocked[i] = asked.nearest[i].hit.t < limits[i];
        return;
    }
    // A hit at the light is given beforehand: only nearer ones replace it.
    asked.farthest.assign(limits.begin(), limits.end());
    asked.farthest.resize(rays.size() + SlabBatch::padding);
    forEachMet(rays, asked, [&](const Entry& entry) {
        entry.object->shape->nearest(asked.rays, context, asked.nearest);
        for (std::size_t k = 0; k < asked.indices.size(); ++k) {
            const std::uint32_t i = asked.indices[k];
            if (!(asked.nearest[k].hit.t < limits[i])) continue;
            blocked[i] = 1;
            // Others need not be asked about it.
            asked.farthest[i] = -1;
        }
    });
}

}  // namespace isoscope
