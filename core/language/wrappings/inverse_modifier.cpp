// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <span>

#include "core/language/objects/wrapping_modifier.h"
#include "core/shapes/combined/inverse_shape.h"

namespace isoscope {

namespace {

/// Twice is none.
void read(WrappingReader&, Wrapping& wrapping) { wrapping.on = !wrapping.on; }

ShapePointer wrap(ShapePointer shape, const Wrapping&, std::vector<ShapePointer>) { return inverseOf(shape); }

}  // namespace

std::span<const WrappingModifier> inverseModifier() {
    static constexpr std::array modifiers{
        WrappingModifier{.keyword = "inverse", .order = 1, .read = read, .wrap = wrap},
    };
    return modifiers;
}

}  // namespace isoscope
