// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
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
    // Periodic ones of the scene's patterns, each a whole that bounds know more of than of its parts.
    fraction,      ///< a - floor(a)
    triangleWave,  ///< f < 0.5 ? 2 f : 2 (1 - f) for the fraction f of a
    cycle,         ///< sin(2 pi f) for the fraction f of |a|, with the sign of a: sin(2 pi a)

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

// The operations of one and of two operands, for code that has a rule of the same name for each of them:
// those for which bounds of slopes are known in passing (SlopeAlgebra, TaylorAlgebra), and the others.
// clang-format off
#define ISOSCOPE_SLOPED_OPERATIONS(UNARY, BINARY) \
    UNARY(negate) UNARY(absolute) UNARY(square) UNARY(squareRoot) UNARY(exponential) UNARY(sine) UNARY(cosine) \
    UNARY(cycle) \
    BINARY(add) BINARY(subtract) BINARY(multiply) BINARY(divide) BINARY(minimum) BINARY(maximum)
#define ISOSCOPE_OTHER_OPERATIONS(UNARY, BINARY) \
    UNARY(naturalLogarithm) UNARY(decimalLogarithm) UNARY(tangent) \
    UNARY(arcSine) UNARY(arcCosine) UNARY(arcTangent) \
    UNARY(hyperbolicSine) UNARY(hyperbolicCosine) UNARY(hyperbolicTangent) \
    UNARY(areaSine) UNARY(areaCosine) UNARY(areaTangent) \
    UNARY(floor) UNARY(ceiling) UNARY(truncate) UNARY(fraction) UNARY(triangleWave) \
    BINARY(power) BINARY(arcTangent2) BINARY(remainder) BINARY(integerDivide) \
    BINARY(equal) BINARY(notEqual) BINARY(less) BINARY(lessEqual) BINARY(greater) BINARY(greaterEqual) \
    BINARY(logicalAnd) BINARY(logicalOr)
// clang-format on

/// Whether it is a component of the vector noise DNoise, and noiseComponent() has a meaning.
constexpr bool isVectorNoise(Operation operation) {
    return operation >= Operation::noiseGradientX && operation <= Operation::noiseGradientZ;
}

/// Which component of the vector noise an operation is: 0, 1 or 2.
constexpr int noiseComponent(Operation operation) {
    return static_cast<int>(operation) - static_cast<int>(Operation::noiseGradientX);
}

/// How a function of the scene language takes the operands of an operation.
enum class CallForm : std::uint8_t {
    none,     ///< it is no function, or the function of another operation
    plain,    ///< one argument for each operand
    folded,   ///< two or more, one after the other: `min(a, b, c)`
    special,  ///< by rules of its own, which FunctionCallParser knows: `pow`, `select`
    loop,     ///< by rules of its own, and inside of function bodies only: `sum`, `prod`
};

/// For which numbers expressions of the scene call a function; with others they report a mistake.
enum class SceneDomain : std::uint8_t { all, positive, unit };

/// Operations for which POV-Ray takes about the same time (core/study/accuracy/povray_time.cpp).
enum class PovrayWork : std::uint8_t { sum, product, quotient, wave, power, noise, vectorNoise, cell };

/// What is known of an operation beside its value, which evaluateOperation() has: all that the languages and
/// the exports ask for.
struct OperationFacts {
    std::string_view name;  ///< short and in lower case, for messages, dumps and tests
    int arity = 0;          ///< number of operands; -1 for loops, which have two more than they capture
    PovrayWork work = PovrayWork::sum;
    std::string_view call = {};  ///< the function with its arguments, "atan2(A, B)"; empty: there is none
    CallForm form = CallForm::none;
    bool common = false;  ///< VirtuaLight and formulas without `function` write it the same way
    SceneDomain domain = SceneDomain::all;
    std::string_view text = {};  ///< how it is written otherwise than by `call`; # and @ are its operands

    /// The name of the function, "atan2".
    constexpr std::string_view word() const { return call.substr(0, call.find('(')); }
};

/// A row for each operation, in the order of the enumeration.
inline constexpr auto operationTable = [] {
    using enum PovrayWork;
    using enum CallForm;
    using enum SceneDomain;
    constexpr CallForm no = CallForm::none;
    return std::to_array<OperationFacts>({
        {"constant", 0},
        {"variable", 0},
        {"parameter", 0},

        {"negate", 1, sum, {}, no, true, all, "(-#)"},
        {"abs", 1, sum, "abs(A)", plain, true},
        {"square", 1, product, {}, no, true, all, "pow(#, 2)"},
        {"sqrt", 1, quotient, "sqrt(A)", plain, true},
        {"exp", 1, wave, "exp(A)", plain, true},
        {"ln", 1, wave, "ln(A)", plain, true, positive},
        {"log", 1, wave, "log(A)", plain, true, positive},
        {"sin", 1, wave, "sin(A)", plain, true},
        {"cos", 1, wave, "cos(A)", plain, true},
        {"tan", 1, wave, "tan(A)", plain, true},
        {"asin", 1, wave, "asin(A)", plain, true, unit},
        {"acos", 1, wave, "acos(A)", plain, true, unit},
        {"atan", 1, wave, "atan(A)", plain, true},
        {"sinh", 1, wave, "sinh(A)", plain, true},
        {"cosh", 1, wave, "cosh(A)", plain, true},
        {"tanh", 1, wave, "tanh(A)", plain, true},
        {"asinh", 1, wave, "asinh(A)", plain, true},
        {"acosh", 1, wave, "acosh(A)", plain, true},
        {"atanh", 1, wave, "atanh(A)", plain, true},
        {"floor", 1, quotient, "floor(A)", plain, true},
        {"ceil", 1, quotient, "ceil(A)", plain, true},
        {"int", 1, quotient, "int(A)", plain, true},
        {"fraction", 1, quotient, {}, no, true, all, "(# - floor(#))"},
        {"triangle",
         1,
         quotient,
         {},
         no,
         false,
         all,
         "select(# - floor(#) - 0.5, 2*(# - floor(#)), 2*(1 - (# - floor(#))))"},
        {"cycle",
         1,
         wave,
         {},
         no,
         false,
         all,
         "select(#, -sin(6.283185307179586*(-# - floor(-#))), sin(6.283185307179586*(# - floor(#))))"},

        {"add", 2, sum, {}, no, true, all, "(# + @)"},
        {"subtract", 2, sum, {}, no, true, all, "(# - @)"},
        {"multiply", 2, product, {}, no, true, all, "(#*@)"},
        {"divide", 2, quotient, {}, no, true, all, "(#/@)"},
        {"pow", 2, power, "pow(A, B)", special, true},
        {"atan2", 2, power, "atan2(A, B)", plain, true},
        {"mod", 2, power, "mod(A, B)", plain, true},
        {"div", 2, quotient, "div(A, B)", plain},
        {"min", 2, sum, "min(A, B)", folded, true},
        {"max", 2, sum, "max(A, B)", folded, true},
        {"equal", 2, sum, {}, no, false, all, "(# = @)"},
        {"not-equal", 2, sum, {}, no, false, all, "(# != @)"},
        {"less", 2, sum, {}, no, false, all, "(# < @)"},
        {"less-equal", 2, sum, {}, no, false, all, "(# <= @)"},
        {"greater", 2, sum, {}, no, false, all, "(# > @)"},
        {"greater-equal", 2, sum, {}, no, false, all, "(# >= @)"},
        {"and", 2},
        {"or", 2},

        {"select3", 3, sum, "select(A, B, C)", special},
        {"select4", 4, sum, "select(A, B, C, D)", no},
        {"noise", 4, noise},
        {"noise-x", 3, vectorNoise},
        {"noise-y", 3, vectorNoise},
        {"noise-z", 3, vectorNoise},
        {"crackle", 3, cell},
        {"sum", -1, sum, "sum(I, A, B, F)", loop},
        {"prod", -1, sum, "prod(I, A, B, F)", loop},
    });
}();
static_assert(operationTable.size() == operationCount, "each operation has one row");

/// The row of an operation.
constexpr const OperationFacts& factsOf(Operation operation) {
    return operationTable[static_cast<std::size_t>(operation)];
}

/// A short lower-case name for messages, dumps and tests ("sin", "min").
constexpr std::string_view name(Operation operation) { return factsOf(operation).name; }

/// Number of operands; -1 for loops, which have as many as they capture plus two.
constexpr int arity(Operation operation) { return factsOf(operation).arity; }

}  // namespace isoscope
