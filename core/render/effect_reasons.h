// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <string>

#include "core/render/effect_description.h"
#include "core/scene/scene.h"

namespace isoscope {

/// "1 light", "2 lights".
std::string counted(std::size_t count, const std::string& noun);

/// "light_source at line 3", as far as its line is known.
std::string placeOf(const LightSource& light);
/// The same of an object, by its name.
std::string placeOf(const SceneObject& object);

/// How many objects have a property: a member, or what a function of the object says.
template <class Property>
std::size_t countObjects(const Scene& scene, Property property) {
    return static_cast<std::size_t>(
        std::count_if(scene.objects.begin(), scene.objects.end(),
                      [&](const SceneObject& object) { return std::invoke(property, object); }));
}

/// Whether some ray can see the object.
inline bool isSeen(const SceneObject& object) { return object.visible || object.reflected; }

/// The first light that is not `shadowless`, or null.
const LightSource* firstCastingLight(const Scene& scene);

/// That there are such objects, and what they do, or why the effect is not needed.
EffectReason reasonOfObjects(const Scene& scene, const std::function<bool(const SceneObject&)>& isSuch,
                             const std::string& does, const std::string& none);

}  // namespace isoscope
