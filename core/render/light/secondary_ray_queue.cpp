// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/light/secondary_ray_queue.h"

#include <algorithm>

namespace isoscope {

namespace {

/// So many mirrors with an exponent are kept apart in a batch; further ones count as if they had none.
constexpr std::size_t bentLimit = 100'000;

double greatest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

}  // namespace

bool SecondaryRayQueue::mayGo(std::uint32_t sample, TileScratch& work) {
    std::uint32_t& sent = work.sentRays[sample];
    if (sent < rayLimit) {
        ++sent;
        return true;
    }
    if (sent == rayLimit) {
        ++work.cutSamples;
        ++sent;
    }
    return false;
}

void SecondaryRayQueue::send(const SecondaryRayRequest& glance, const SampleBatch& batch,
                             TileScratch& work) const {
    const LightPath& from = batch.path(glance.sample);
    if (from.level >= settings_.maxTraceLevel || from.steps >= stepLimit) return;
    glm::dvec3 weight = from.weight * glance.weight;
    if (!batch.through.empty()) weight *= batch.through[glance.sample];
    const double seen = greatest(weight) * glance.seen;
    if (!(seen > 0 && seen >= settings_.adcBailout)) return;
    const std::uint32_t target = batch.target(glance.sample);
    const std::size_t samples = work.batch.size();
    const std::uint32_t sample = target < samples ? target : work.bentSights[target - samples].sample;
    if (!mayGo(sample, work)) return;
    SecondaryRay later;
    later.ray = glance.ray;
    later.sender = glance.sender;
    later.path.weight = weight;
    later.path.target = target;
    later.path.level = static_cast<std::uint16_t>(from.level + (glance.straight ? 0 : 1));
    later.path.steps = static_cast<std::uint16_t>(from.steps + 1);
    later.path.reflected = from.reflected || glance.reflected;
    later.path.inside = glance.inside;
    later.path.dispersed = from.dispersed || glance.dispersed;
    later.path.spectralPlace = from.dispersed ? from.spectralPlace : glance.spectralPlace;
    if (glance.exponent != 1 && glance.exponent > 0 && work.bentSights.size() < bentLimit) {
        const auto number = static_cast<std::uint32_t>(samples + work.bentSights.size());
        work.bentSights.push_back({glm::dvec3(0), weight, target, sample, 1 / glance.exponent});
        later.path.target = number;
        later.path.weight = glm::dvec3(1);
    }
    work.laterRays.push_back(later);
}

}  // namespace isoscope
