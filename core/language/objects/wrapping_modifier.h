// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "core/language/tokens/token_stream.h"
#include "core/shapes/shape.h"
#include "core/shapes/transform.h"

namespace isoscope {

struct ObjectDescription;
struct WrappingModifier;
using ObjectPointer = std::shared_ptr<const ObjectDescription>;

/// A shape of `clipped_by` or `bounded_by`, with the transforms that came after it.
struct ClippingObject {
    ObjectPointer object;
    Transform transform;
};

/// What an object says of one modifier, however often.
struct Wrapping {
    const WrappingModifier* modifier = nullptr;
    bool on = false;  ///< whether anything goes around the object
    std::vector<ClippingObject> objects = {};
};

/// What modifiers are read with.
struct WrappingReader {
    TokenStream& tokens;
    /// The object that the modifier belongs to, as far as it has been read.
    const ObjectDescription& description;
    /// Reads the next object of a block: null when it is not drawn, nothing when none comes.
    std::function<std::optional<ObjectPointer>()> nextObject;
};

/// A modifier that puts a shape around the object's own: all that the language knows of it.
///
/// Each file of core/language/wrappings has one function of its own name, in clipping_modifier.cpp
/// `std::span<const WrappingModifier> clippingModifier()`, which gives its rows (as for ShapeParser).
struct WrappingModifier {
    std::string_view keyword;
    /// POV-Ray's order, which does not depend on that of the text: smaller ones are further in.
    int order = 0;
    /// Reads what follows the keyword into what was said before.
    void (*read)(WrappingReader&, Wrapping&) = nullptr;
    /// The shape with this around it; `objects` are the shapes of wrapping.objects.
    ShapePointer (*wrap)(ShapePointer shape, const Wrapping& wrapping,
                         std::vector<ShapePointer> objects) = nullptr;
    /// Whether it does no more than keep rays off: a union passes it on to its parts, and
    /// ShapeParser::ignoresOwnBounds is about it.
    bool limitsRays = false;
};

/// The rows of all files, in their order.
const std::vector<WrappingModifier>& wrappingModifiers();

/// The modifier with the keyword; null for other words.
const WrappingModifier* findWrappingModifier(std::string_view keyword);

/// Reads `{ ... }` with objects, and adds them. In their place `other` may stand, the keyword of a modifier,
/// for the objects of that.
void readObjects(WrappingReader& reader, Wrapping& wrapping, std::string_view other);

}  // namespace isoscope
