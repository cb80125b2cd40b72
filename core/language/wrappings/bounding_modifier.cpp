// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <span>

#include "core/language/objects/wrapping_modifier.h"
#include "core/shapes/combined/bounded_shape.h"

namespace isoscope {

namespace {

void read(WrappingReader& reader, Wrapping& wrapping) { readObjects(reader, wrapping, "clipped_by"); }

ShapePointer wrap(ShapePointer shape, const Wrapping&, std::vector<ShapePointer> limits) {
    return boundedBy(std::move(shape), limits);
}

}  // namespace

std::span<const WrappingModifier> boundingModifier() {
    static constexpr std::array modifiers{
        WrappingModifier{.keyword = "bounded_by", .order = 3, .read = read, .wrap = wrap, .limitsRays = true},
    };
    return modifiers;
}

}  // namespace isoscope
