// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/progressive/tile_scratch.h"

namespace isoscope {

/// What a stage wants to see from a place of a batch.
struct SecondaryRayRequest {
    std::uint32_t sample = 0;  ///< whose ray has met the place
    Ray ray;
    glm::dvec3 weight{1};  ///< what the sample gets of it
    double seen = 1;       ///< a factor of the weight that adc_bailout is compared with, beside it
    StageKind sender = StageKind::reflection;
    InteriorList inside;     ///< where the ray goes
    bool reflected = false;  ///< a mirror has turned it
    bool straight = false;   ///< it goes on as it came
    bool dispersed = false;  ///< as LightPath, where the place has taken white light apart
    float spectralPlace = 0;
    double exponent = 1;  ///< what is seen counts to the power of 1 / this
};

/// Puts rays of stages on TileScratch::laterRays, as far as they count: not beyond max_trace_level (rays that
/// go straight on do not add to it, as in POV-Ray), nor below adc_bailout.
///
/// Where every surface both mirrors and lets through, the rays double from level to level, to 2^64 at
/// level 64. So a sample of the picture may send `rayLimit` of them. The full tree of max_trace_level 14 has
/// fewer, and so have surfaces that give away no more light than they get (255 rays a level with the default
/// adc_bailout) through 64 levels. What is asked for beyond counts as black; TileScratch::cutSamples tells of
/// it. Which rays these are depends on the tile alone, not on the number of threads.
class SecondaryRayQueue {
  public:
    /// Surfaces that one line of sight goes through.
    static constexpr int stepLimit = 1000;
    /// Later rays of one sample of the picture.
    static constexpr std::uint32_t rayLimit = 1 << 14;

    SecondaryRayQueue(const GlobalSettings& settings) : settings_(settings) {}

    /// Adds the ray to `work.laterRays`, or drops it by the limits above. `batch` holds the request's sample,
    /// whose weight and losses on the way multiply the ray's. `work` belongs to the calling thread.
    void send(const SecondaryRayRequest& glance, const SampleBatch& batch, TileScratch& work) const;

  private:
    /// Whether the sample of the picture may send one more; counts it then.
    static bool mayGo(std::uint32_t sample, TileScratch& work);

    const GlobalSettings& settings_;
};

}  // namespace isoscope
