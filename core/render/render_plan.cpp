// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/render_plan.h"

#include <algorithm>
#include <utility>

#include "core/render/effect_description.h"

namespace isoscope {

const char* name(StageKind kind) { return descriptionOf(kind).name; }

bool canBeLeftOut(StageKind kind) { return descriptionOf(kind).canBeLeftOut; }

bool RenderPlan::has(StageKind kind) const {
    return std::any_of(stages.begin(), stages.end(),
                       [kind](const PlannedStage& stage) { return stage.kind == kind; });
}

RenderPlan makePlan(const Scene& scene, const StageSet& leftOut) {
    RenderPlan plan;
    for (std::size_t i = 0; i < stageKindCount; ++i) {
        const auto kind = static_cast<StageKind>(i);
        const EffectDescription& effect = descriptionOf(kind);
        EffectReason reason = effect.reasonFor(scene);
        const bool out = reason.needed && leftOut.has(kind) && effect.canBeLeftOut;
        if (out) reason.words += effect.leftOutNote;
        std::vector<PlannedStage>& list = out             ? plan.leftOut
                                          : reason.needed ? plan.stages
                                                          : plan.notCalledFor;
        list.push_back({kind, std::move(reason.words)});
    }
    return plan;
}

}  // namespace isoscope
