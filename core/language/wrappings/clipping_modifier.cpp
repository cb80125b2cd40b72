// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <span>

#include "core/language/objects/wrapping_modifier.h"
#include "core/shapes/combined/clipped_shape.h"
#include "core/shapes/composition.h"
#include "core/shapes/patches/bicubic_patch.h"

namespace isoscope {

namespace {

void read(WrappingReader& reader, Wrapping& wrapping) { readObjects(reader, wrapping, "bounded_by"); }

/// POV-Ray cuts nothing off bicubic patches (seen in its pictures).
bool isUncut(const ShapePointer& shape) {
    const Composition made = shape->composition();
    if (made.kind == Composition::Kind::wrapped) return isUncut(made.parts.front());
    return dynamic_cast<const BicubicPatch*>(shape.get()) != nullptr;
}

ShapePointer wrap(ShapePointer shape, const Wrapping&, std::vector<ShapePointer> clips) {
    if (isUncut(shape)) return shape;
    return std::make_shared<ClippedShape>(std::move(shape), std::move(clips));
}

}  // namespace

std::span<const WrappingModifier> clippingModifier() {
    static constexpr std::array modifiers{
        WrappingModifier{.keyword = "clipped_by", .order = 2, .read = read, .wrap = wrap},
    };
    return modifiers;
}

}  // namespace isoscope
