// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <span>

#include "core/language/objects/wrapping_modifier.h"
#include "core/shapes/combined/clipped_shape.h"

namespace isoscope {

namespace {

void read(WrappingReader& reader, Wrapping& wrapping) { readObjects(reader, wrapping, "bounded_by"); }

ShapePointer wrap(ShapePointer shape, const Wrapping&, std::vector<ShapePointer> clips) {
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
