// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/render_plan.h"

#include <algorithm>
#include <set>

namespace isoscope {

namespace {

std::string counted(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string placeOf(const LightSource& light) {
    return light.line > 0 ? "light_source at line " + std::to_string(light.line) : "a light_source";
}

void planTextures(const Scene& scene, RenderPlan& plan) {
    std::set<const Tape*> patterns;
    bool some = false;
    for (const Material& material : scene.materials) {
        some |= material.patterned();
        for (const auto& tape : {material.pigmentTape, material.normalTape, material.mapTape})
            if (tape) patterns.insert(tape.get());
    }
    if (some)
        plan.stages.push_back(
            {StageKind::textures, "textures", "materials with " + counted(patterns.size(), "pattern")});
}

void planSky(const Scene& scene, RenderPlan& plan) {
    if (scene.sky && !scene.sky->layers.empty())
        plan.stages.push_back(
            {StageKind::sky, "sky", "a sky_sphere with " + counted(scene.sky->layers.size(), "pigment")});
}

void planShadows(const Scene& scene, RenderPlan& plan) {
    const auto casts = [](const LightSource& light) { return !light.shadowless; };
    const auto light = std::find_if(scene.lights.begin(), scene.lights.end(), casts);
    const auto occluders = static_cast<std::size_t>(std::count_if(
        scene.objects.begin(), scene.objects.end(), [](const SceneObject& o) { return o.castsShadow; }));
    if (light == scene.lights.end()) {
        plan.notCalledFor.push_back(scene.lights.empty() ? "shadows: there is no light"
                                                         : "shadows: every light is shadowless");
    } else if (occluders == 0) {
        plan.notCalledFor.push_back("shadows: every object is no_shadow");
    } else {
        plan.stages.push_back({StageKind::shadows, "shadows",
                               placeOf(*light) + " casts; " + counted(occluders, "object") + " can occlude"});
    }
}

}  // namespace

bool RenderPlan::has(StageKind kind) const {
    return std::any_of(stages.begin(), stages.end(),
                       [kind](const PlannedStage& s) { return s.kind == kind; });
}

RenderPlan makePlan(const Scene& scene) {
    RenderPlan plan;
    const auto visible = static_cast<std::size_t>(std::count_if(
        scene.objects.begin(), scene.objects.end(), [](const SceneObject& o) { return o.visible; }));
    if (visible == 0) {
        plan.stages.push_back({StageKind::background, "background", "nothing stands in front of it"});
        planSky(scene, plan);
        plan.notCalledFor = {"primary rays: there is no visible object",
                             "direct light: there is nothing to light",
                             "shadows: there is nothing to fall on"};
        return plan;
    }
    plan.stages.push_back({StageKind::primaryRays, "primary rays", counted(visible, "visible object")});
    plan.stages.push_back({StageKind::background, "background", "rays that meet nothing show it"});
    planSky(scene, plan);
    planTextures(scene, plan);
    plan.stages.push_back(
        {StageKind::directLight, "direct light",
         scene.lights.empty()
             ? "objects shine by their ambient and emission; there is no light"
             : counted(scene.lights.size(), "light") + ", first " + placeOf(scene.lights.front())});
    planShadows(scene, plan);
    return plan;
}

}  // namespace isoscope
