// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/virtualight/names.h"

#include <numbers>

#include "core/language/tokens/symbol_table.h"

namespace isoscope::virtualight {

Names::Names() {
    const auto number = [this](const char* name, double value) { declare(name, DeclaredNumber{value, -1}); };
    number("PI", std::numbers::pi);
    // Not defined in the text; half of pi closes the surface of its example.
    number("PI_TWO", std::numbers::pi / 2);
    number("BEZIER", 1);
    number("BSPLINE", 2);
    number("CATMULLROM", 3);
    number("HERMITE", 4);
    number("STRAIGHT", 1);
    number("POLYNOMIAL", 2);
    number("CONDITIONAL", 3);
    number("OFF", 0);
    number("ON", 1);
}

const DeclaredThing* Names::find(std::string_view name) const {
    const auto found = names_.find(name);
    return found == names_.end() ? nullptr : &found->second;
}

std::string Names::closest(std::string_view name) const {
    std::vector<std::string> known;
    for (const auto& [word, thing] : names_) known.push_back(word);
    for (const char* word :
         {"x", "y", "z", "u", "v", "phi", "theta", "cos", "sin", "exp", "sqrt", "radians", "CurrentFrame"})
        known.push_back(word);
    return closestName(name, known);
}

}  // namespace isoscope::virtualight
