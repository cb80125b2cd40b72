// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/render_plan.h"

#include <algorithm>
#include <array>
#include <functional>
#include <set>

namespace isoscope {

namespace {

constexpr std::array<const char*, stageKindCount> names{
    "primary rays",    "background",   "sky",
    "surround",        "textures",     "direct light",
    "projected light", "shadows",      "light through glass",
    "area lights",     "grain",        "fog",
    "rainbow",         "transparency", "refraction",
    "reflection",      "focal blur",   "camera normal"};

/// Whether a scene calls for a stage, and why or why not.
struct Call {
    bool needed;
    std::string reason;
};

std::string counted(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string placeOf(const LightSource& light) {
    return light.line > 0 ? "light_source at line " + std::to_string(light.line) : "a light_source";
}

template <class Property>
std::size_t countObjects(const Scene& scene, Property property) {
    return static_cast<std::size_t>(
        std::count_if(scene.objects.begin(), scene.objects.end(),
                      [&](const SceneObject& object) { return std::invoke(property, object); }));
}

Call callPrimaryRays(const Scene& scene) {
    const std::size_t visible = countObjects(scene, &SceneObject::visible);
    if (visible == 0) return {false, "there is no visible object"};
    return {true, counted(visible, "visible object")};
}

Call callBackground(const Scene& scene) {
    return {true, countObjects(scene, &SceneObject::visible) == 0 ? "nothing stands in front of it"
                                                                  : "rays that meet nothing show it"};
}

Call callSky(const Scene& scene) {
    if (!scene.sky || scene.sky->layers.empty()) return {false, "there is no sky_sphere"};
    return {true, "a sky_sphere with " + counted(scene.sky->layers.size(), "pigment")};
}

Call callSurround(const Scene& scene) {
    const CameraKind kind = scene.camera.kind;
    if (kind != CameraKind::fisheye && kind != CameraKind::omnimax)
        return {false, "the camera fills the picture"};
    return {true, "the picture of the camera is round"};
}

Call callTextures(const Scene& scene) {
    if (countObjects(scene, &SceneObject::visible) == 0) return {false, "there is nothing to paint"};
    std::set<const Tape*> patterns;
    bool some = false;
    for (const Material& material : scene.materials) {
        some |= material.patterned();
        for (const auto& tape : {material.pigmentTape, material.normalTape, material.mapTape})
            if (tape) patterns.insert(tape.get());
    }
    if (!some) return {false, "every material is plain"};
    return {true, "materials with " + counted(patterns.size(), "pattern")};
}

Call callDirectLight(const Scene& scene) {
    if (countObjects(scene, &SceneObject::visible) == 0) return {false, "there is nothing to light"};
    if (scene.lights.empty()) return {true, "objects shine by their ambient and emission; there is no light"};
    return {true, counted(scene.lights.size(), "light") + ", first " + placeOf(scene.lights.front())};
}

Call callShadows(const Scene& scene) {
    if (countObjects(scene, &SceneObject::visible) == 0) return {false, "there is nothing to fall on"};
    if (scene.lights.empty()) return {false, "there is no light"};
    const auto light = std::find_if(scene.lights.begin(), scene.lights.end(),
                                    [](const LightSource& each) { return !each.shadowless; });
    if (light == scene.lights.end()) return {false, "every light is shadowless"};
    if (countObjects(scene, &SceneObject::castsShadow) == 0) return {false, "every object is no_shadow"};
    const auto occluders = countObjects(
        scene, [](const SceneObject& object) { return object.castsShadow && !object.transparent; });
    if (occluders == 0) return {false, "every object that casts is transparent"};
    return {true, placeOf(*light) + " casts; " + counted(occluders, "object") + " can occlude"};
}

std::string placeOf(const SceneObject& object) {
    return object.line > 0 ? object.name + " at line " + std::to_string(object.line) : object.name;
}

/// That there are such objects, and what they do, or why the stage is not needed.
template <class Property>
Call callObjects(const Scene& scene, Property property, const std::string& does, const std::string& none) {
    const auto first = std::find_if(scene.objects.begin(), scene.objects.end(), property);
    if (first == scene.objects.end()) return {false, none};
    return {true, placeOf(*first) + " " + does + "; " + counted(countObjects(scene, property), "object") +
                      " in all"};
}

bool isSeen(const SceneObject& object) { return object.visible || object.reflected; }

Call callClearShadows(const Scene& scene) {
    const auto light = std::find_if(scene.lights.begin(), scene.lights.end(),
                                    [](const LightSource& each) { return !each.shadowless; });
    if (light == scene.lights.end()) return {false, "no light casts shadows"};
    return callObjects(
        scene, [](const SceneObject& object) { return object.castsShadow && object.transparent; },
        "lets light through", "no transparent object casts");
}

Call callAreaLights(const Scene& scene) {
    const auto soft = [](const LightSource& light) { return light.area && !light.shadowless; };
    const auto light = std::find_if(scene.lights.begin(), scene.lights.end(), soft);
    if (light == scene.lights.end()) return {false, "no light that casts shadows has an area"};
    const Call shadows = callShadows(scene);
    if (!shadows.needed && !callClearShadows(scene).needed) return shadows;
    return {true, placeOf(*light) + " has " +
                      counted(static_cast<std::size_t>(light->area->columns) *
                                  static_cast<std::size_t>(light->area->rows),
                              "light")};
}

Call callGrain(const Scene& scene) {
    const auto grainy = [](const Material& material) { return material.finish.crand > 0; };
    const auto count = std::count_if(scene.materials.begin(), scene.materials.end(), grainy);
    if (count == 0) return {false, "no finish has crand"};
    if (scene.lights.empty()) return {false, "there is no light"};
    return {true, counted(static_cast<std::size_t>(count), "material") + " with crand"};
}

Call callFocalBlur(const Scene& scene) {
    const FocalBlur& blur = scene.camera.blur;
    if (!blur.any()) return {false, "the camera has no aperture"};
    return {true, "the camera has an aperture; up to " +
                      counted(static_cast<std::size_t>(blur.samples), "ray") + " a pixel"};
}

Call callFog(const Scene& scene) {
    const auto fog = std::find_if(scene.fogs.begin(), scene.fogs.end(),
                                  [](const Fog& each) { return each.distance != 0; });
    if (fog == scene.fogs.end()) return {false, "there is no fog"};
    const std::string place = fog->line > 0 ? "fog at line " + std::to_string(fog->line) : "a fog";
    return {true, place + "; " + counted(scene.fogs.size(), "fog") + " in all"};
}

Call callRainbow(const Scene& scene) {
    if (scene.rainbows.empty()) return {false, "there is no rainbow"};
    const int line = scene.rainbows.front().line;
    return {true, (line > 0 ? "rainbow at line " + std::to_string(line) : "a rainbow") + "; " +
                      counted(scene.rainbows.size(), "rainbow") + " in all"};
}

Call callProjection(const Scene& scene) {
    const auto light = std::find_if(scene.lights.begin(), scene.lights.end(),
                                    [](const LightSource& each) { return each.projectedThrough != nullptr; });
    if (light == scene.lights.end()) return {false, "no light is projected through an object"};
    return {true, placeOf(*light) + " is projected through an object"};
}

Call callCameraNormal(const Scene& scene) {
    if (!scene.camera.normalTape) return {false, "the camera has no normal"};
    return {true, "the camera has a normal that bends its rays"};
}

Call callTransparency(const Scene& scene) {
    return callObjects(
        scene, [](const SceneObject& object) { return isSeen(object) && object.transparent; },
        "lets light through", "every object is opaque");
}

Call callRefraction(const Scene& scene) {
    if (!callTransparency(scene).needed) return {false, "every object is opaque"};
    const auto bends = [&](const SceneObject& object) {
        return isSeen(object) && object.transparent && object.bendsLight;
    };
    return callObjects(scene, bends, "has an ior", "no transparent object has an ior");
}

Call callReflection(const Scene& scene) {
    return callObjects(
        scene, [](const SceneObject& object) { return isSeen(object) && object.reflective; }, "mirrors",
        "no finish has reflection");
}

/// What a picture shows instead of a stage that is left out, where it may surprise; else empty.
std::string without(StageKind kind) {
    // To look straight through takes as many rays as the stage itself: then it would not be left out. Who
    // wants that leaves out refraction.
    if (kind == StageKind::transparency)
        return "; without it these objects are drawn as opaque, and nothing is refracted";
    if (kind == StageKind::refraction) return "; without it light goes straight through";
    if (kind == StageKind::clearShadows) return "; without it these objects cast no shadow";
    return {};
}

/// In the order of StageKind, which is that in which they run.
constexpr std::array<Call (*)(const Scene&), stageKindCount> calls{
    callPrimaryRays, callBackground,   callSky,          callSurround,   callTextures,  callDirectLight,
    callProjection,  callShadows,      callClearShadows, callAreaLights, callGrain,     callFog,
    callRainbow,     callTransparency, callRefraction,   callReflection, callFocalBlur, callCameraNormal};

}  // namespace

const char* name(StageKind kind) { return names[static_cast<std::size_t>(kind)]; }

bool canBeLeftOut(StageKind kind) {
    return kind != StageKind::primaryRays && kind != StageKind::background &&
           kind != StageKind::directLight && kind != StageKind::surround;
}

bool RenderPlan::has(StageKind kind) const {
    return std::any_of(stages.begin(), stages.end(),
                       [kind](const PlannedStage& stage) { return stage.kind == kind; });
}

RenderPlan makePlan(const Scene& scene, const StageSet& leftOut) {
    RenderPlan plan;
    for (std::size_t i = 0; i < stageKindCount; ++i) {
        const auto kind = static_cast<StageKind>(i);
        Call call = calls[i](scene);
        const bool out = call.needed && leftOut.has(kind) && canBeLeftOut(kind);
        if (out) call.reason += without(kind);
        std::vector<PlannedStage>& list = out ? plan.leftOut : call.needed ? plan.stages : plan.notCalledFor;
        list.push_back({kind, std::move(call.reason)});
    }
    return plan;
}

}  // namespace isoscope
