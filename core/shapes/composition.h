// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>

#include "core/shapes/shape.h"

namespace isoscope {

/// How a shape is made of others. Code that walks through shapes asks for this and knows none of the classes
/// that wrap shapes; a new one is understood everywhere once it says what it is made of, and rebuilds itself
/// from other parts (Shape::withParts). Valid as long as the shape.
struct Composition {
    /// What becomes of the parts. A difference is an intersection with complements.
    enum class Kind {
        primitive,   ///< made of no other shape
        wrapped,     ///< its only part, perhaps moved or limited, and nothing that is not said here
        complement,  ///< its only part with inside and outside changed
        union_,      ///< every surface of its parts
        merge,       ///< a union without the surfaces inside another part
        intersection,
    };

    Kind kind = Kind::primitive;
    std::span<const ShapePointer> parts = {};
    // Of `wrapped` only.
    std::span<const ShapePointer> limits = {};  ///< they show no surface of their own
    /// Whether what lies outside of a limit is cut off; otherwise limits only keep rays off.
    bool limitsCut = false;
    const Transform* transform = nullptr;  ///< of the part and the limits; null: they stay where they are
    MaterialId material = noMaterial;      ///< of hits that have none of their own
};

/// What becomes of a part.
using PartChange = std::function<ShapePointer(const ShapePointer& part)>;

/// The shape with its parts changed, and its limits when `changeLimit` is given; the very same shape when
/// that changes nothing, and when it is a primitive.
ShapePointer withChanged(const ShapePointer& shape, const PartChange& changePart,
                         const PartChange& changeLimit = {});

}  // namespace isoscope
