// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/functions/function_words.h"

#include <algorithm>
#include <array>
#include <map>

#include "core/language/tokens/words.h"

namespace isoscope {

namespace {

constexpr std::array<ElementaryFunction, 31> functions{{
    {"abs", 1, Operation::absolute},
    {"sqrt", 1, Operation::squareRoot},
    {"exp", 1, Operation::exponential},
    {"ln", 1, Operation::naturalLogarithm},
    {"log", 1, Operation::decimalLogarithm},
    {"sin", 1, Operation::sine},
    {"cos", 1, Operation::cosine},
    {"tan", 1, Operation::tangent},
    {"asin", 1, Operation::arcSine},
    {"acos", 1, Operation::arcCosine},
    {"atan", 1, Operation::arcTangent},
    {"sinh", 1, Operation::hyperbolicSine},
    {"cosh", 1, Operation::hyperbolicCosine},
    {"tanh", 1, Operation::hyperbolicTangent},
    {"asinh", 1, Operation::areaSine},
    {"acosh", 1, Operation::areaCosine},
    {"atanh", 1, Operation::areaTangent},
    {"floor", 1, Operation::floor},
    {"ceil", 1, Operation::ceiling},
    {"int", 1, Operation::truncate},
    // Multiplied by one rounded factor; the call parser knows which.
    {"degrees", 1, Operation::multiply},
    {"radians", 1, Operation::multiply},
    {"atan2", 2, Operation::arcTangent2},
    {"mod", 2, Operation::remainder},
    {"div", 2, Operation::integerDivide},
    {"pow", 0, Operation::power},
    {"min", 0, Operation::minimum},
    {"max", 0, Operation::maximum},
    {"select", 0, Operation::select3},
    {"sum", 0, Operation::sum},
    {"prod", 0, Operation::product},
}};

}  // namespace

const ElementaryFunction* findElementaryFunction(std::string_view name) {
    const auto* known = std::ranges::find(functions, name, &ElementaryFunction::name);
    return known == functions.end() ? nullptr : &*known;
}

bool mayNameVariable(std::string_view name) {
    static constexpr std::array<std::string_view, 5> coordinates{"x", "y", "z", "u", "v"};
    const Word* word = findWord(name);
    return !word || !word->known() || std::ranges::find(coordinates, name) != coordinates.end();
}

std::string refusedWordReason(std::string_view word) {
    static const std::map<std::string_view, std::string_view> reasons{
        {"true", "write 1"},
        {"yes", "write 1"},
        {"on", "write 1"},
        {"false", "write 0"},
        {"no", "write 0"},
        {"off", "write 0"},
        {"sqr", "write the product, or pow(..., 2)"},
        {"cube", "write the product, or pow(..., 3)"},
        {"t", "it names the fourth component of a vector; choose another name"},
        {"version", "declare a float with its value before the function"},
        {"now", "declare a float with its value before the function"},
        {"rand", "declare a float with its value before the function"},
        {"seed", "declare a float with its value before the function"},
        {"val", "declare a float with its value before the function"},
        {"strlen", "declare a float with its value before the function"},
        {"asc", "declare a float with its value before the function"},
        {"vlength", "take the vector apart: sqrt(x*x + y*y + z*z)"},
        {"vdot", "take the vectors apart"},
        {"inside", "declare a function of your own that tells inside from outside"},
        {"function", "declare the inner function first, then call it"},
    };
    const auto known = reasons.find(word);
    return known == reasons.end() ? std::string() : std::string(known->second);
}

}  // namespace isoscope
