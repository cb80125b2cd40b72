// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/composition.h"

namespace isoscope {

namespace {

/// The shapes, changed; `changed` becomes true when one of them is another one then.
std::vector<ShapePointer> changedShapes(std::span<const ShapePointer> shapes, const PartChange& change,
                                        bool& changed) {
    std::vector<ShapePointer> result(shapes.begin(), shapes.end());
    if (!change) return result;
    for (ShapePointer& shape : result) {
        ShapePointer next = change(shape);
        changed = changed || next != shape;
        shape = std::move(next);
    }
    return result;
}

}  // namespace

ShapePointer withChanged(const ShapePointer& shape, const PartChange& changePart,
                         const PartChange& changeLimit) {
    const Composition made = shape->composition();
    bool changed = false;
    std::vector<ShapePointer> parts = changedShapes(made.parts, changePart, changed);
    std::vector<ShapePointer> limits = changedShapes(made.limits, changeLimit, changed);
    return changed ? shape->withParts(std::move(parts), std::move(limits)) : shape;
}

}  // namespace isoscope
