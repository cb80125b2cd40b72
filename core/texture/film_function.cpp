// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/film_function.h"

#include "core/function/patterns/pattern_call.h"

namespace isoscope {

Function filmFunction(const Finish& finish, int noiseGenerator) {
    FunctionGraph graph;
    const auto variable = [&](int k) { return Expression(graph, graph.variable(k)); };
    Pattern pattern;
    pattern.octaves = 5;
    const Expression value = turbulence({pattern, variable(0), variable(1), variable(2), noiseGenerator});
    const Expression thickness = finish.iridThickness * (1 + finish.iridTurbulence * (2 * value - 1));
    return isoscope::finish(std::move(graph), {thickness.node()}, 3);
}

}  // namespace isoscope
