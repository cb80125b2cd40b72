// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace isoscope {

enum class StageKind { primaryRays, background, sky, textures, directLight, shadows };
constexpr std::size_t stageKindCount = 6;

/// One effect that the scene calls for, and why ("light_source at line 12 casts; 3 objects can occlude").
struct PlannedStage {
    StageKind kind;
    std::string name;
    std::string reason;
};

/// The stages a scene calls for, in the order in which they run; what is not listed costs nothing.
/// `notCalledFor` names the others, for the effects panel.
struct RenderPlan {
    std::vector<PlannedStage> stages;
    std::vector<std::string> notCalledFor;

    bool has(StageKind kind) const;
};

/// A pure function of the scene.
RenderPlan makePlan(const Scene& scene);

}  // namespace isoscope
