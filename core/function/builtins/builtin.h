// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/function/graph_builder.h"

namespace isoscope {

/// One extra parameter P0, P1, ... of a built-in, as the slider needs it.
struct BuiltinParameter {
    std::string name;  ///< "Field Strength"
    double defaultValue = 0;
    double minimum = 0;
    double maximum = 1;
};

/// An isosurface that shows a function: what "insert" writes. Seen whole where the surface ends, no part lost
/// for want of max_gradient, and no more of that than needed; tests/app/inserted_function_test.cpp sees to
/// it.
struct Showing {
    std::string expression;  ///< of x, y, z: mostly the call; patterns raise a ball
    std::string container;   ///< as Builtin::container
    double threshold = 0;
    double maxGradient = 1;
    /// A function that jumps has no surface without holes, whatever the max_gradient: this call of it is to
    /// colour the surface instead. Empty for all others.
    std::string paint;
};

/// A function of functions.inc: the numbered built-ins and the pattern functions. The facts come from
/// `functions.csv`; the formula is written once, as a graph.
struct Builtin {
    std::string name;  ///< "f_torus"; internal(77) has no name and is found by its number only
    int id = -1;       ///< number in internal(n); -1 for pattern functions
    std::vector<BuiltinParameter> parameters;  ///< behind x, y, z
    int pointArguments = 3;                    ///< 3; 0 for f_sine_wave and f_scallop_wave
    std::string formula;                       ///< one line for the insert list, in plain text
    double threshold = 0;                      ///< the rest are sensible settings for showing it
    std::string container;                     ///< "sphere 0 1.1" or "box <...> <...>"
    double maxGradient = 1.1;
    bool invert = false;  ///< show the negated function
    std::string kind;     ///< "builtin", "pattern", ...
    Showing showing;

    /// Arguments of a call: the point's, then the parameters.
    int argumentCount() const { return pointArguments + static_cast<int>(parameters.size()); }
};

/// All built-ins, sorted by id, then name; and the one with a name or number, null when there is none.
std::span<const Builtin> builtins();
const Builtin* findBuiltin(std::string_view name);
const Builtin* findBuiltin(int id);

/// Builds the formula in the graph of the arguments. `arguments` holds argumentCount() expressions of one
/// graph; `noiseGenerator` is the scene's, for those that follow it. Parameters that decide the structure
/// (octaves, cross-section type) must not be sliders' slots to be unrolled; any expression is allowed all the
/// same. A count (octaves, tubes) that is a constant is honoured up to `octaveLimit` or `tubeLimit`, any
/// other expression up to `variableCountLimit`; a larger one acts like the limit.
Expression buildBuiltin(const Builtin& builtin, std::span<const Expression> arguments, int noiseGenerator);

constexpr int octaveLimit = 64;
constexpr int tubeLimit = 256;
constexpr int variableCountLimit = 32;

/// The call as a person would type it, with the parameters' defaults: "f_torus(x, y, z, 0.8, 0.2)".
std::string sampleCall(const Builtin& builtin);

/// Whether parameter `index` decides the structure of the formula, so that a change of it
/// needs a new graph: counts, and the switches that are cheaper decided while building (cross-section type,
/// SOR switch, noise generator).
bool isStructural(const Builtin& builtin, int index);

}  // namespace isoscope
