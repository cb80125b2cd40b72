// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/formulas/difference_text.h"

#include <glm/common.hpp>

#include "core/exchange/function_text.h"
#include "core/text/number_format.h"

namespace isoscope {

namespace {

std::string vectorText(const glm::dvec3& v) {
    return '<' + shortestNumber(v.x) + ", " + shortestNumber(v.y) + ", " + shortestNumber(v.z) + '>';
}

/// f - threshold; nothing where it cannot be written.
std::optional<std::string> levelText(const Isosurface& surface, std::span<const double> parameters) {
    auto text = functionText(surface.settings().function, {"x", "y", "z"}, parameters);
    const double threshold = surface.settings().threshold;
    if (text && threshold != 0) *text = "(" + *text + " - (" + shortestNumber(threshold) + "))";
    return text;
}

}  // namespace

DifferenceText differenceText(const Isosurface& a, std::span<const double> parametersOfA, const Isosurface& b,
                              std::span<const double> parametersOfB) {
    const auto first = levelText(a, parametersOfA), second = levelText(b, parametersOfB);
    if (!first || !second)
        return {{},
                "The function cannot be written as one formula: it has loops, noise or patterns, or is too "
                "long."};
    const Bounds one = a.bounds(), other = b.bounds();
    const double steepness = a.rootSettings().maxGradient + b.rootSettings().maxGradient;
    return {"// 0 where the functions A and B agree: A - B.\nisosurface {\n  function { " + *first + " - " +
                *second + " }\n  contained_by { box { " + vectorText(glm::min(one.low, other.low)) + ", " +
                vectorText(glm::max(one.high, other.high)) + " } }\n  max_gradient " +
                shortestNumber(steepness) + "\n  pigment { rgb 0.8 }\n}\n",
            {}};
}

}  // namespace isoscope
