// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace isoscope {

/// The operations of a function graph. Values are IEEE doubles; what each does with NaN, infinities and
/// out-of-range arguments is POV-Ray 3.7's, as measured in `docs/povray/operators.md` and
/// `docs/povray/noise.md`. Every evaluator has one rule per operation; nothing else in the program states a
/// formula twice.
enum class Operation : std::uint8_t {
    constant,   ///< Node::value
    variable,   ///< argument number Node::index of the function; 0, 1, 2 are x, y, z of an isosurface
    parameter,  ///< slot Node::index of the scene's parameter table (a slider)

    // one operand
    negate,
    absolute,
    square,  ///< a*a; its bounds know that both factors are the same
    squareRoot,
    exponential,
    naturalLogarithm,
    decimalLogarithm,
    sine,
    cosine,
    tangent,
    arcSine,
    arcCosine,
    arcTangent,
    hyperbolicSine,
    hyperbolicCosine,
    hyperbolicTangent,
    areaSine,
    areaCosine,
    areaTangent,
    floor,
    ceiling,
    truncate,  ///< `int`: toward zero through a 32-bit integer, -2147483648 when out of range

    // two operands
    add,
    subtract,
    multiply,
    divide,
    power,
    arcTangent2,    ///< atan2(a, b): a is the ordinate
    remainder,      ///< `mod`: sign of a
    integerDivide,  ///< `div`: through a 32-bit integer
    minimum,        ///< a <= b ? a : b
    maximum,        ///< a < b ? b : a
    equal,
    notEqual,
    less,
    lessEqual,
    greater,       ///< NaN counts as greater: 1 when either side is NaN
    greaterEqual,  ///< likewise
    logicalAnd,
    logicalOr,

    // three and four operands
    select3,  ///< a < 0 ? b : c
    select4,  ///< a < 0 ? b : a == 0 ? c : d (a NaN gives d)

    // operands: generator number (taken as in docs/povray/noise.md, section 6, after resolution of the
    // scene's own), x, y,
    // z
    noise,
    // operands: x, y, z; one component each of the vector noise DNoise
    noiseGradientX,
    noiseGradientY,
    noiseGradientZ,
    crackle,  ///< or a table of points: operands x, y, z; settings FunctionGraph::crackle(Node::index)

    /// Loops: operands are first and last value of the loop variable, then the values captured by the body;
    /// the body is FunctionGraph::loopBody(Node::index), whose variable 0 is the loop variable and whose
    /// variables 1, 2, ... are the captured values.
    sum,
    product,

    count_
};

constexpr int operationCount = static_cast<int>(Operation::count_);

/// Whether it is a component of the vector noise DNoise, and noiseComponent() has a meaning.
constexpr bool isVectorNoise(Operation operation) {
    return operation >= Operation::noiseGradientX && operation <= Operation::noiseGradientZ;
}

/// Which component of the vector noise an operation is: 0, 1 or 2.
constexpr int noiseComponent(Operation operation) {
    return static_cast<int>(operation) - static_cast<int>(Operation::noiseGradientX);
}

/// A short lower-case name for messages, dumps and tests ("sine", "min").
std::string_view name(Operation operation);

/// Number of operands; -1 for loops, which have as many as they capture plus two.
int arity(Operation operation);

}  // namespace isoscope
