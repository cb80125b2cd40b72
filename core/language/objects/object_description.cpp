// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/objects/object_description.h"

#include <algorithm>

namespace isoscope {

const Wrapping* ObjectDescription::wrapping(std::string_view word) const {
    const auto found =
        std::ranges::find_if(wrappings, [&](const Wrapping& each) { return each.modifier->keyword == word; });
    return found == wrappings.end() ? nullptr : &*found;
}

Wrapping& ObjectDescription::wrapping(const WrappingModifier& modifier) {
    const auto next = std::ranges::find_if(
        wrappings, [&](const Wrapping& wrapping) { return wrapping.modifier->order >= modifier.order; });
    if (next != wrappings.end() && next->modifier == &modifier) return *next;
    return *wrappings.insert(next, {.modifier = &modifier});
}

}  // namespace isoscope
