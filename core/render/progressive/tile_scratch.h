// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/render/camera/pixel.h"
#include "core/render/light/gathered_rays.h"
#include "core/render/light/light_path.h"
#include "core/render/light/shadow_rays.h"
#include "core/render/render_plan.h"
#include "core/render/sample_batch.h"
#include "core/shapes/trace_context.h"

namespace isoscope {

/// What one stage has cost.
struct StageMeter {
    std::uint64_t rays = 0;
    std::uint64_t evaluations = 0;
    double cpuSeconds = 0;      ///< known in the end (TileScratch::finish)
    std::uint64_t blocked = 0;  ///< rays of these that were to reach a light and do not
};

/// The slots of TileScratch::verdicts: with POV-Ray's root finder a HitKind or a miss, with the certified one
/// its Verdict.
constexpr std::size_t missCount = static_cast<std::size_t>(HitKind::pole) + 1;
constexpr std::size_t firstCertainty = missCount + 1;
constexpr std::size_t verdictCount = firstCertainty + static_cast<std::size_t>(Verdict::notCertified) + 1;

/// All that drawing one tile changes. Each tile begins with one that is restarted: what shapes remember
/// between rays then depends on the tile alone, and the picture not on the number of threads.
struct TileScratch {
    static constexpr std::size_t largestBatch = 1024;

    TraceContext context;
    std::size_t batchRays = largestBatch;  ///< so many go through the stages together

    SampleBatch batch;                    ///< of the picture
    SampleBatch later;                    ///< of what the surfaces mirror and let through
    const SampleBatch* lit = nullptr;     ///< whose points light filters are asked about
    std::vector<SecondaryRay> laterRays;  ///< those that are still to be sent for `batch`
    /// What mirrors with an exponent see, until it is added to `batch`, or to an earlier one of these: their
    /// numbers follow those of the samples.
    struct PowerReflection {
        glm::dvec3 seen{0}, weight{1};
        std::uint32_t target = 0;
        std::uint32_t sample = 0;  ///< of `batch`, to which it comes in the end
        double power = 1;
    };
    std::vector<PowerReflection> bentSights;
    std::vector<std::uint32_t> sentRays;  ///< what each sample of `batch` has sent so far of `laterRays`
    std::uint64_t cutSamples = 0;   ///< samples that asked for more of them than they may (SecondaryRayQueue)
    std::vector<double> distances;  ///< how far the rays of a batch go, where a stage has to know
    GatheredRays gathered;
    ShadowRays shadow;
    std::vector<PixelIndex> pixels;      ///< of the tile, in order
    std::vector<LinearColor> colors;     ///< theirs
    std::vector<std::uint32_t> encoded;  ///< the same for the screen
    /// Of transparent pictures: how much of the background each sample of `batch` shows, and of each pixel
    /// how much hides it (Image::opacity).
    std::vector<double> backgroundSeen;
    std::vector<float> opacity;
    std::array<StageMeter, stageKindCount> meters;
    std::array<std::uint64_t, verdictCount> verdicts{};

    /// Resets everything; only the lists keep their memory and the shapes their evaluators.
    void restart();

    /// Where a stage counts the rays it sends; finish() adds its CPU time.
    StageMeter& meter(StageKind kind) { return meters[static_cast<std::size_t>(kind)]; }
    /// From now on time and evaluations belong to the stage that is charged next.
    void startMeter();
    /// Charges a stage with what was spent since the last charge.
    void charge(StageKind kind);
    /// The tile, or several of them, is drawn, and its colours are where they belong: all CPU time since
    /// restart() is shared out to the stages, in the proportions of the time that passed on the clock. The
    /// clock of CPU time is a call into the system, too slow to be read for every stage.
    void finish();
    /// Of all of it, after finish().
    double cpuSeconds() const { return cpuSeconds_; }

  private:
    double begunSeconds_ = 0;  ///< CPU time of the thread at restart()
    double cpuSeconds_ = 0;
    std::uint64_t charged_ = 0;  ///< ticks at the last charge
    std::array<std::uint64_t, stageKindCount> elapsed_{};
    std::uint64_t chargedEvaluations_ = 0;
};

/// CPU time of the calling thread in seconds.
double threadCpuSeconds();

}  // namespace isoscope
