// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/scene_finish.h"

#include <string>
#include <string_view>
#include <utility>

#include "core/language/default_view.h"
#include "core/language/scene_builder.h"
#include "core/language/statement_description.h"
#include "core/texture/compile_materials.h"

namespace isoscope {

namespace {

/// The materials that statements have added for themselves.
std::vector<Material*> ownMaterials(Scene& scene) {
    std::vector<Material*> materials;
    for (const StatementDescription* statement : statementDescriptions)
        if (statement->addMaterials) statement->addMaterials(scene, materials);
    return materials;
}

/// The object that a text without a scene shows: the one it declares last; of several that one statement
/// declares, the first by name.
ObjectPointer lastDeclared(const SymbolTable& symbols) {
    ObjectPointer last;
    std::string nameOfLast;
    symbols.forEach([&](const std::string& name, const Value& value) {
        const auto* object = std::get_if<ObjectPointer>(&value.data);
        if (!object || !*object || (*object)->range.file != 0) return;
        const bool isLater = !last || std::pair((*object)->range.begin, std::string_view(nameOfLast)) >
                                          std::pair(last->range.begin, std::string_view(name));
        if (!isLater) return;
        last = *object;
        nameOfLast = name;
    });
    return last;
}

/// Whether a material shows anything but black, by a colour or as a mirror.
bool hasColor(const Material& material) {
    return material.pigmentStated || material.map || !material.below.empty() || material.finish.reflects();
}

/// A part of the object that shows, but nothing gives it a colour; null when there is none.
const ObjectDescription* partWithoutPigment(const ObjectDescription& object) {
    if ((object.material && hasColor(*object.material)) || object.partTextures || !object.visible)
        return nullptr;
    if (object.shape || object.isosurface) return &object;
    for (const ObjectPointer& part : object.parts)
        if (const ObjectDescription* found = partWithoutPigment(*part)) return found;
    return nullptr;
}

/// The fix for an object without a pigment: one in front of its closing brace.
std::vector<QuickFix> pigmentFix(const SourceLibrary& sources, const SourceRange& object) {
    const std::string_view text = sources.slice(object);
    if (object.file != 0 || !text.ends_with('}')) return {};
    const std::size_t line = text.rfind('\n');
    const bool ownLine =
        line != std::string_view::npos && text.find_first_not_of(" \t", line + 1) == text.size() - 1;
    const std::uint32_t at = ownLine ? object.begin + static_cast<std::uint32_t>(line) + 1 : object.end - 1;
    const bool spaced = text.size() > 1 && text[text.size() - 2] == ' ';
    return {
        {"Add a Pigment",
         {0, at, at},
         ownLine ? "  pigment { rgb 0.8 }\n" : (spaced ? "" : " ") + std::string("pigment { rgb 0.8 } ")}};
}

/// Objects are black where nothing says their colour, on a background that is black, too.
void noteMissingPigments(const SceneDraft& draft, ParseContext& context) {
    for (const SceneDraft::Entry& entry : draft.objects) {
        if (hasColor(draft.defaultMaterials[entry.defaultMaterial])) continue;
        const ObjectDescription* part = partWithoutPigment(*entry.object);
        if (!part) continue;
        Diagnostic note{Severity::note,
                        "no-pigment",
                        entry.object->range,
                        "This `" + part->keyword + "` has no pigment: POV-Ray shows it black.",
                        {},
                        {}};
        if (!context.keeps(note)) continue;
        note.fixes = pigmentFix(context.sources, entry.object->range);
        context.report(std::move(note));
    }
}

/// POV-Ray 3.7 draws a scene that never says its version by the rules of 3.62; told to those whose picture it
/// changes. A text without camera and lights is a scene only here.
void noteMissingVersion(const SceneDraft& draft, ParseContext& context) {
    const bool isScene = draft.hasCamera || !draft.scene.lights.empty();
    if (!isScene || context.versionStated || context.hasAssumedGamma) return;
    context.note(
        "no-version", {},
        "The text does not say its `#version`: POV-Ray shows it darker than here, by the rules of version "
        "3.62.",
        "begin it with `#version 3.7;` and `global_settings { assumed_gamma 1 }`");
}

}  // namespace

void finishScene(SceneDraft& draft, ParseContext& context) {
    Scene& scene = draft.scene;
    noteMissingPigments(draft, context);
    if (draft.objects.empty()) {
        if (const ObjectPointer object = lastDeclared(context.symbols)) {
            draft.objects.push_back({object, draft.defaultMaterials.size() - 1});
            context.report({Severity::note,
                            "declared-only",
                            object->range,
                            "The text only declares objects; the last one is shown.",
                            {},
                            {}});
        }
    }
    scene.parameterTable = std::make_shared<const std::vector<double>>(context.parameterTable);
    SceneBuilder builder(scene);
    for (const SceneDraft::Entry& entry : draft.objects) {
        if (context.stopAsked()) break;
        builder.add(entry.object, draft.defaultMaterials[entry.defaultMaterial]);
    }
    noteMissingVersion(draft, context);
    scene.languageVersion = context.languageVersion;
    scene.settings.noiseGenerator = context.noiseGenerator;
    if (!context.hasAssumedGamma)
        scene.settings.assumedGamma = context.languageVersion >= 370 ? 1 : srgbGamma;
    if (!context.stopAsked() && !compileMaterials(scene, ownMaterials(scene)))
        context.report({Severity::leftOut,
                        "left-out",
                        SourceRange(),
                        "A pattern is too large to be simulated; what it colours is drawn in grey.",
                        {},
                        {}});
    for (std::size_t k = 0; k < context.parameters.size(); ++k)
        if (!context.counters.contains(static_cast<int>(k)))
            scene.parameters.push_back(std::move(context.parameters[k]));
    addDefaultView(draft, context);
    if (context.stopAsked() && context.complete) context.report(context.stopMessage({}));
}

}  // namespace isoscope
