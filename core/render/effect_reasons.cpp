// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/effect_reasons.h"

namespace isoscope {

std::string counted(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string placeOf(const LightSource& light) {
    return light.line > 0 ? "light_source at line " + std::to_string(light.line) : "a light_source";
}

std::string placeOf(const SceneObject& object) {
    return object.line > 0 ? object.name + " at line " + std::to_string(object.line) : object.name;
}

const LightSource* firstCastingLight(const Scene& scene) {
    const auto light = std::find_if(scene.lights.begin(), scene.lights.end(),
                                    [](const LightSource& each) { return !each.shadowless; });
    return light == scene.lights.end() ? nullptr : &*light;
}

EffectReason reasonOfObjects(const Scene& scene, const std::function<bool(const SceneObject&)>& isSuch,
                             const std::string& does, const std::string& none) {
    const auto first = std::find_if(scene.objects.begin(), scene.objects.end(), isSuch);
    if (first == scene.objects.end()) return {false, none};
    return {true,
            placeOf(*first) + " " + does + "; " + counted(countObjects(scene, isSuch), "object") + " in all"};
}

}  // namespace isoscope
