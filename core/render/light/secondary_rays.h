// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "core/render/light/object_tracer.h"
#include "core/render/stages/stage.h"

namespace isoscope {

/// Follows the light behind the first hit: sends the rays that stages have put on TileScratch::laterRays, a
/// batch at a time, carries them through the same stages as samples of the picture, and adds what they see to
/// TileScratch::batch. The newest go first, and in smaller batches the more are waiting, so that their number
/// stays bounded, however many there will be.
class SecondaryRays {
  public:
    /// Rays that go through the stages together when `waitingRays` or more are waiting; while few are, it is
    /// TileScratch::batchRays. On the way down through n levels at which each ray
    /// sends m others, so many times n * m may be added to them.
    static constexpr std::size_t smallestBatch = 32;
    static constexpr std::size_t waitingRays = 1 << 17;
    /// What lies nearer than this to the start of a ray is the surface that has sent it.
    static constexpr double startTolerance = 1e-4;

    /// The scene must outlive this.
    explicit SecondaryRays(const Scene& scene);

    /// Before the stages see the samples of TileScratch::batch.
    static void begin(TileScratch& work) { work.sentRays.assign(work.batch.size(), 0); }

    /// Until no ray is left. `stages` are those behind the first hit, in order. Before each batch `stopped`
    /// is asked; false when it said so.
    bool follow(TileScratch& work, std::span<const std::unique_ptr<Stage>> stages,
                const std::function<bool()>& stopped) const;

  private:
    /// The rays that are found by the same objects and charged to the same stage.
    struct Group {
        StageKind sender;
        bool reflected;
    };
    static Group groupOf(const SecondaryRay& ray) { return {ray.sender, ray.path.reflected}; }
    void findHits(const Group& group, TileScratch& work, SampleBatch& batch) const;

    ObjectTracer visible_;                     ///< for rays that no mirror has turned
    std::unique_ptr<ObjectTracer> reflected_;  ///< for the others; null when they meet the same objects
};

}  // namespace isoscope
