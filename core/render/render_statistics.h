// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/render/render_plan.h"
#include "core/shapes/isosurface/isosurface.h"

namespace isoscope {

/// What one stage of a picture cost, and why it ran (PlannedStage::reason); sums over all threads.
struct StageReport {
    StageKind kind;
    std::string reason;
    std::uint64_t rays = 0;
    std::uint64_t evaluations = 0;
    double cpuSeconds = 0;
    std::uint64_t blocked = 0;  ///< rays of these that were to reach a light and do not
};

/// What a picture cost; sums over all threads.
struct RenderStatistics {
    double cpuSeconds = 0;
    std::uint64_t rays = 0;
    std::uint64_t evaluations = 0;
    /// Samples of the picture that send more rays from surface to surface than SecondaryRayQueue::rayLimit;
    /// what these would have shown counts as black.
    std::uint64_t cutSamples = 0;
    std::map<std::string, std::uint64_t> verdicts;  ///< pixels by verdict ("hit", "miss", ...)
    std::vector<StageReport> stages;                ///< that ran
    std::vector<PlannedStage> leftOut;              ///< as RenderPlan::leftOut
    std::vector<PlannedStage> notCalledFor;         ///< as RenderPlan::notCalledFor
    /// One entry per SceneIsosurface, in order.
    std::vector<RootFinderReport> gradients;
};

/// POV-Ray's warnings about max_gradient (docs/povray/solver.md); empty when it would say nothing.
std::string gradientWarning(const RootFinderReport& report);

/// That the light of some samples was cut short, and what helps; empty when none was.
std::string cutWarning(const RenderStatistics& statistics);

}  // namespace isoscope
