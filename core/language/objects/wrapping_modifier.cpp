// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/objects/wrapping_modifier.h"

#include <algorithm>
#include <string>

#include "core/language/objects/object_description.h"
#include "core/language/scene_draft.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/shapes/patches/polygon.h"

namespace isoscope {

/// The rows of all files of core/language/wrappings; CMake writes it.
std::vector<WrappingModifier> gatherWrappingModifiers();

const std::vector<WrappingModifier>& wrappingModifiers() {
    static const auto sorted = [] {
        std::vector<WrappingModifier> modifiers = gatherWrappingModifiers();
        std::ranges::sort(modifiers, {}, &WrappingModifier::order);
        return modifiers;
    }();
    return sorted;
}

const WrappingModifier* findWrappingModifier(std::string_view keyword) {
    const std::vector<WrappingModifier>& all = wrappingModifiers();
    const auto found = std::ranges::find(all, keyword, &WrappingModifier::keyword);
    return found == all.end() ? nullptr : &*found;
}

namespace {

/// POV-Ray takes polygons, but no other patches, alone or in unions and the like. Counts the parts looked at.
bool isRefused(const ObjectDescription& object, std::size_t& parts) {
    ++parts;
    if (object.shape && object.shape->isPatch()) return !dynamic_cast<const Polygon*>(object.shape.get());
    return std::ranges::any_of(object.parts,
                               [&](const ObjectPointer& part) { return isRefused(*part, parts); });
}

}  // namespace

void readObjects(WrappingReader& reader, Wrapping& wrapping, std::string_view other) {
    TokenStream& tokens = reader.tokens;
    const std::string keyword(wrapping.modifier->keyword);
    if (!tokens.expect("{", "to begin `" + keyword + "`")) return;
    const bool isSame = tokens.accept(other);
    if (isSame)
        if (const Wrapping* named = reader.description.wrapping(other))
            wrapping.objects.insert(wrapping.objects.end(), named->objects.begin(), named->objects.end());
    SourceRange start = tokens.peek().range;
    while (const std::optional<ObjectPointer> object = reader.nextObject()) {
        constexpr std::size_t partsPerStep = 16;
        std::size_t parts = 0;
        const bool refused = *object && isRefused(**object, parts);
        if (!tokens.charge(parts / partsPerStep, tokens.lastRange())) break;
        if (refused)
            warnOfRefusal(tokens.context(), rangeSince(start, tokens),
                          "takes no patch in `" + keyword + "`: it has no inside.", "use a solid");
        if (*object) wrapping.objects.push_back({*object, {}});
        start = tokens.peek().range;
    }
    wrapping.on = !wrapping.objects.empty();
    if (tokens.accept("}")) {
        if (!wrapping.on && !isSame)
            warnOfRefusal(tokens.context(), tokens.lastRange(), "wants an object in `" + keyword + "`.",
                          "leave the block out, or write a shape into it");
        return;
    }
    tokens.context().error(
        "unexpected-token", tokens.peek().range,
        "Expected an object or `}` in `" + keyword + "`, but found " + describe(tokens.peek()) + ".");
    tokens.skipBlock();
}

}  // namespace isoscope
