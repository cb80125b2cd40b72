// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/render/gathered_rays.h"
#include "core/render/pixel.h"
#include "core/render/render_plan.h"
#include "core/render/sample_batch.h"
#include "core/render/shadow_rays.h"
#include "core/shapes/trace_context.h"

namespace isoscope {

/// What one stage has cost.
struct StageMeter {
    std::uint64_t rays = 0;
    std::uint64_t evaluations = 0;
    double cpuSeconds = 0;
};

/// What is counted of a picture: the kinds of hit and the miss with POV-Ray's root finder, the verdicts of
/// the certified one with that.
constexpr std::size_t missCount = static_cast<std::size_t>(HitKind::gap) + 1;
constexpr std::size_t firstCertainty = missCount + 1;
constexpr std::size_t verdictCount = firstCertainty + static_cast<std::size_t>(Verdict::notCertified) + 1;

/// All that drawing one tile changes. Each tile begins with one that is as new: what shapes remember between
/// rays then depends on the tile alone, and the picture not on the number of threads.
struct TileWork {
    TraceContext context;
    SampleBatch batch;
    GatheredRays gathered;
    ShadowRays shadow;
    std::vector<PixelIndex> pixels;   ///< of the tile, in order
    std::vector<LinearColor> colors;  ///< theirs
    std::array<StageMeter, stageKindCount> meters;
    std::array<std::uint64_t, verdictCount> verdicts{};

    /// As new, but the lists keep their memory and the shapes their evaluators.
    void restart() {
        context.restart();
        meters = {};
        verdicts = {};
    }

    StageMeter& meter(StageKind kind) { return meters[static_cast<std::size_t>(kind)]; }
    /// From now on CPU time and evaluations belong to the stage that is charged next.
    void startMeter();
    /// Charges a stage with what was spent since the last charge. The clock is a call into the system: one
    /// reading serves as the end of one stage and the beginning of the next.
    void charge(StageKind kind);

  private:
    double chargedSeconds_ = 0;  ///< CPU time of the thread at the last charge
    std::uint64_t chargedEvaluations_ = 0;
};

/// CPU time of the calling thread in seconds.
double threadCpuSeconds();

}  // namespace isoscope
