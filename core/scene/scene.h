// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/function/written_work.h"
#include "core/scene/camera.h"
#include "core/scene/fog.h"
#include "core/scene/interior.h"
#include "core/scene/light_source.h"
#include "core/scene/material.h"
#include "core/scene/medium.h"
#include "core/scene/rainbow.h"
#include "core/shapes/isosurface/isosurface.h"
#include "core/shapes/shape.h"
#include "core/shapes/transform.h"
#include "core/text/source_text.h"

namespace isoscope {

/// One visible object: a shape in world coordinates, with the material of everything in it that has none of
/// its own.
struct SceneObject {
    ShapePointer shape;
    MaterialId material = noMaterial;
    bool castsShadow = true;           ///< false for no_shadow
    bool visible = true;               ///< false for no_image
    bool reflected = true;             ///< false for no_reflection
    bool hollow = false;               ///< media and fog fill its inside
    bool doubleIlluminate = false;     ///< lit from both sides
    bool transparent = false;          ///< some light may come through
    bool bendsLight = false;           ///< it, or a part of it, has an ior
    bool reflective = false;           ///< some finish of it mirrors
    InteriorId interior = noInterior;  ///< inside of it; none where no ray can tell
    std::string name;                  ///< what to call it in messages ("isosurface")
    SourceRange range;                 ///< its statement
    int line = 0;                      ///< of its statement, for the plan's reasons
};

/// An isosurface of the scene, however deep in CSG, as the panels need it: with its place in the text.
struct SceneIsosurface {
    std::shared_ptr<const Isosurface> shape;
    Transform transform;        ///< from its own coordinates to the world
    SourceRange range;          ///< the whole statement, modifiers included
    SourceRange functionRange;  ///< between the braces of `function { }`
    std::string functionText;   ///< the text of that range, directives that stand in it included
    std::shared_ptr<const WrittenWork> written;  ///< what its function is to compute; null where no one knows
    SourceRange containerRange;  ///< between the braces of `contained_by { }`; empty where there is none
    int number = 0;  ///< counts isosurface statements as they are read, each time in loops and macros
};

/// Objects with lights of their own.
struct LightGroup {
    bool globalLights = false;  ///< lights that belong to no group reach its objects as well
};

/// The value of GlobalSettings::assumedGamma that stands for the sRGB curve instead of a power law.
constexpr double srgbGamma = 0;

/// `global_settings`, with POV-Ray's defaults.
struct GlobalSettings {
    /// Colours c of the scene stand for the linear light c^assumedGamma; shading computes with c itself.
    /// Where the text says nothing: 1 for #version 3.7 and later, srgbGamma for earlier ones (POV-Ray then
    /// writes its colours unchanged).
    double assumedGamma = 1;
    int noiseGenerator = 2;
    int maxTraceLevel = 5;
    double adcBailout = 1.0 / 255;  ///< rays that count for less are not sent
    int numberOfWaves = 10;
    Color ambientLight{1, 1, 1};
    Color iridWavelength{0.7, 0.52, 0.48};
};

/// What a number of the text sets.
enum class ParameterRole { argument, declared, threshold, accuracy, maxGradient, container, other };

/// A number of the text that a slider can move.
struct SceneParameter {
    ParameterRole role = ParameterRole::other;
    std::string name;   ///< "Major Radius", "R", "threshold"
    std::string group;  ///< the call or statement it belongs to: "f_torus", "#declare", "isosurface"
    int statement = 0;  ///< which one of that name: the same number for all that belong to it; 0 for #declare
    double value = 0;
    double minimum = 0;  ///< sensible range of the slider; `value` may lie outside
    double maximum = 1;
    bool logarithmic = false;
    bool integral = false;
    SourceRange range;  ///< the literal, sign included, or the whole expression
    /// The argument is an expression, not a number: `text` shows it, and a slider is offered in its place.
    bool expression = false;
    std::string text;
    /// The text leaves the setting out, so that its default counts: `range` is the empty place behind which
    /// its name and a number can be written.
    bool implied = false;
    /// Slot in the parameter table, or -1: changing the number then asks for a new parse.
    int slot = -1;
};

/// `sky_sphere`: what rays see that meet nothing, by their direction alone.
struct SkySphere {
    /// Only their pigments count, looked up on the unit sphere; the last lies on top.
    std::vector<Material> layers;
    Color emission{1, 1, 1};  ///< factors of the colours
};

/// Plain data: all that was understood of a text. Shared between threads and never changed after parsing.
struct Scene {
    Camera camera;
    std::vector<LightSource> lights;
    /// The first stands for what is in none. The lights of a group reach its own objects only, not those of
    /// groups within; anything may be in their way.
    std::vector<LightGroup> lightGroups{LightGroup{true}};
    std::vector<SceneObject> objects;
    std::vector<SceneIsosurface> isosurfaces;
    std::vector<Material> materials;
    std::vector<Interior> interiors;
    std::vector<Fog> fogs;
    std::vector<std::shared_ptr<const Medium>> atmosphere;  ///< media of all space; none is null
    std::vector<Rainbow> rainbows;
    Color background{0, 0, 0, 0, 0};
    std::shared_ptr<const SkySphere> sky;  ///< null: the background alone
    GlobalSettings settings;
    int languageVersion = 370;  ///< 100 times #version
    std::vector<SceneParameter> parameters;
    /// Values of the parameter slots.
    std::shared_ptr<const std::vector<double>> parameterTable = std::make_shared<std::vector<double>>();
    /// Where the `camera` block stands, when the text has one: what "write the view into the text" replaces.
    std::optional<SourceRange> cameraRange;
};

/// Whether a light shines on what belongs to a group.
inline bool reaches(const Scene& scene, const LightSource& light, int group) {
    return light.group == group ||
           (light.group == 0 && scene.lightGroups[static_cast<std::size_t>(group)].globalLights);
}

}  // namespace isoscope
