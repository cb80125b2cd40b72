// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/light/secondary_rays.h"

#include <algorithm>
#include <cmath>

#include "core/render/stages/clear_background.h"

namespace isoscope {

namespace {

/// How many rays the next batch may have; `most` while few are waiting.
std::size_t roomWith(std::size_t waiting, std::size_t most) {
    const std::size_t left = SecondaryRays::waitingRays - std::min(waiting, SecondaryRays::waitingRays);
    return std::max(SecondaryRays::smallestBatch, most * left / SecondaryRays::waitingRays);
}

/// Takes the rays of the last one's kind from the last that wait, as many as a batch may have; the others
/// move up.
void take(TileScratch& work, auto sameGroup) {
    std::vector<SecondaryRay>& waiting = work.laterRays;
    SampleBatch& batch = work.later;
    const std::size_t first =
        waiting.size() - std::min(waiting.size(), roomWith(waiting.size(), work.batchRays));
    batch.paths.clear();
    batch.begin();
    batch.rays.reserve(waiting.size() - first);
    batch.rays.setSize(waiting.size() - first);
    std::size_t kept = first;
    for (std::size_t i = first; i < waiting.size(); ++i) {
        if (!sameGroup(waiting[i])) {
            waiting[kept++] = waiting[i];
            continue;
        }
        Ray ray = waiting[i].ray;
        ray.sample = static_cast<std::uint32_t>(batch.paths.size());
        batch.rays.set(batch.paths.size(), ray);
        batch.paths.push_back(waiting[i].path);
    }
    waiting.resize(kept);
    batch.rays.setSize(batch.paths.size());
    batch.colors.resize(batch.paths.size());
}

/// Endless light counts only where it arrives.
void add(const glm::dvec3& color, const glm::dvec3& weight, std::uint32_t target, TileScratch& work) {
    const std::size_t samples = work.batch.size();
    glm::dvec3& sum = target < samples ? work.batch.colors[target] : work.bentSights[target - samples].seen;
    for (int c = 0; c < 3; ++c)
        if (weight[c] > 0) sum[c] += weight[c] * color[c];
}

/// Later ones may belong to earlier ones.
void addPowerReflections(TileScratch& work) {
    for (; !work.bentSights.empty(); work.bentSights.pop_back()) {
        const TileScratch::PowerReflection sight = work.bentSights.back();
        glm::dvec3 color;
        for (int c = 0; c < 3; ++c) color[c] = sight.seen[c] > 0 ? std::pow(sight.seen[c], sight.power) : 0;
        add(color, sight.weight, sight.target, work);
    }
}

}  // namespace

SecondaryRays::SecondaryRays(const Scene& scene)
    : visible_(scene, [](const SceneObject& object) { return object.visible; }) {
    if (std::any_of(scene.objects.begin(), scene.objects.end(),
                    [](const SceneObject& object) { return object.visible != object.reflected; }))
        reflected_ =
            std::make_unique<ObjectTracer>(scene, [](const SceneObject& object) { return object.reflected; });
}

bool SecondaryRays::follow(TileScratch& work, std::span<const std::unique_ptr<Stage>> stages,
                           const std::function<bool()>& stopped) const {
    std::vector<SecondaryRay>& waiting = work.laterRays;
    while (!waiting.empty()) {
        if (stopped()) {
            waiting.clear();
            work.bentSights.clear();
            return false;
        }
        const Group group = groupOf(waiting.back());
        take(work, [&](const SecondaryRay& ray) {
            return ray.sender == group.sender && ray.path.reflected == group.reflected;
        });
        findHits(group, work, work.later);
        for (const auto& stage : stages) stage->run(work, work.later);
        noteBackgroundSeen(work, work.later);
        for (std::size_t i = 0; i < work.later.size(); ++i)
            add(work.later.colors[i], work.later.paths[i].weight, work.later.paths[i].target, work);
    }
    addPowerReflections(work);
    return true;
}

void SecondaryRays::findHits(const Group& group, TileScratch& work, SampleBatch& batch) const {
    const bool missMemory = work.context.missMemory;
    work.context.missMemory = false;
    work.context.nearLimit = startTolerance;
    const ObjectTracer& objects = group.reflected && reflected_ ? *reflected_ : visible_;
    objects.nearest(batch.rays, work.context, work.gathered, batch.hits);
    work.context.nearLimit = 0;
    work.context.missMemory = missMemory;
    batch.points.gather(batch.rays, batch.hits);
    work.meter(group.sender).rays += batch.size();
    work.charge(group.sender);
}

}  // namespace isoscope
