// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bitset>
#include <string>
#include <vector>

#include "core/render/effect_list.h"
#include "core/scene/scene.h"

namespace isoscope {

/// "direct light": as panels and statistics call it.
const char* name(StageKind kind);

/// Whether the preview can do without: false for what makes it a picture at all.
bool canBeLeftOut(StageKind kind);

/// Some of the stages.
class StageSet {
  public:
    /// A new set holds no stage.
    bool has(StageKind kind) const { return stages_[static_cast<std::size_t>(kind)]; }
    void set(StageKind kind, bool on) { stages_[static_cast<std::size_t>(kind)] = on; }
    bool operator==(const StageSet&) const = default;
    StageSet operator|(const StageSet& other) const {
        StageSet both;
        both.stages_ = stages_ | other.stages_;
        return both;
    }

  private:
    std::bitset<stageKindCount> stages_;
};

/// One effect, and why it runs or does not ("light_source at line 12 casts; 3 objects can occlude").
struct PlannedStage {
    StageKind kind;
    std::string reason;
};

/// What a scene calls for. What is not among `stages` costs nothing.
struct RenderPlan {
    std::vector<PlannedStage> stages;        ///< in the order in which they run
    std::vector<PlannedStage> leftOut;       ///< called for, but asked to be left out
    std::vector<PlannedStage> notCalledFor;  ///< all others

    /// Whether the stage is among `stages`, that is: runs.
    bool has(StageKind kind) const;
};

/// A pure function of the scene and of what is to be left out, where it can be.
RenderPlan makePlan(const Scene& scene, const StageSet& leftOut = {});

}  // namespace isoscope
