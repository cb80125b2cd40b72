// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/render/effect_description.h"
#include "core/render/render_plan.h"
#include "core/render/render_request.h"
#include "core/render/stages/filter_chain.h"
#include "core/render/stages/stage.h"

namespace isoscope {

class PrimaryRays;
class Textures;

/// What a picture is drawn by, while its effects add their stages one after another
/// (EffectDescription::build). The request, its scene and the plan outlive all of it.
struct PictureParts {
    const RenderRequest& request;
    const RenderPlan& plan;

    std::unique_ptr<PrimaryRays> primaryRays{};
    std::vector<std::unique_ptr<Stage>> stages{};  ///< behind the primary rays, in order
    /// What the direct light asks; effects behind it may still add to them.
    std::shared_ptr<LightFilters> lightFilters = std::make_shared<LightFilters>();
    const Textures* textures = nullptr;  ///< among `stages`, or null
    bool sendsRays = false;              ///< some stage puts rays on TileScratch::laterRays
    bool knowsInteriors = false;         ///< some stage asks which interiors a ray is in
    bool onlySurfaces = true;            ///< no stage changes samples whose rays have met nothing

    /// The scene of the request.
    const Scene& scene() const { return *request.scene; }
    /// Appends a stage.
    void addStage(std::unique_ptr<Stage> stage) {
        stages.push_back(std::move(stage));
        onlySurfaces = false;
    }
    /// Appends a stage that leaves samples alone whose rays have met nothing, and sends no rays on.
    void addSurfaceStage(std::unique_ptr<Stage> stage) { stages.push_back(std::move(stage)); }
};

}  // namespace isoscope
