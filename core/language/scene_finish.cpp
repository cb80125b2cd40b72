// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/scene_finish.h"

#include "core/language/default_view.h"
#include "core/language/scene_builder.h"
#include "core/texture/compile_materials.h"

namespace isoscope {

namespace {

/// The object that a text without a scene shows: the one it declares last.
ObjectPointer lastDeclared(const SymbolTable& symbols) {
    ObjectPointer last;
    for (const std::string& name : symbols.names()) {
        const auto* object = std::get_if<ObjectPointer>(&symbols.find(name)->data);
        if (!object || !*object || (*object)->range.file != 0) continue;
        if (!last || (*object)->range.begin > last->range.begin) last = *object;
    }
    return last;
}

/// POV-Ray 3.7 draws a scene that never says its version by the rules of 3.62; told to those whose picture it
/// changes. A text without camera and lights is a scene only here.
void noteMissingVersion(const SceneDraft& draft, ParseContext& context) {
    const bool isScene = draft.hasCamera || !draft.scene.lights.empty();
    if (!isScene || context.versionStated || draft.hasAssumedGamma) return;
    context.note(
        "no-version", {},
        "The text does not say its `#version`: POV-Ray takes its colours for those of the screen, as for "
        "version 3.62; here it is drawn by the rules of 3.7.",
        "begin it with `#version 3.7;` and `global_settings { assumed_gamma 1 }`");
}

}  // namespace

void finishScene(SceneDraft& draft, ParseContext& context) {
    Scene& scene = draft.scene;
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
    if (!draft.hasAssumedGamma) scene.settings.assumedGamma = context.languageVersion >= 370 ? 1 : srgbGamma;
    if (!context.stopAsked() && !compileMaterials(scene))
        context.report({Severity::leftOut,
                        "left-out",
                        SourceRange(),
                        "A pattern is too large to be simulated; what it colours is drawn in grey.",
                        {},
                        {}});
    scene.parameters = std::move(context.parameters);
    addDefaultView(draft, context);
    if (context.stopAsked() && context.complete)
        context.error("stopped", {}, "Reading was stopped here.", "it begins anew when the text changes");
}

}  // namespace isoscope
