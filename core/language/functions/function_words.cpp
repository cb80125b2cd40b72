// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/functions/function_words.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "core/language/tokens/words.h"

namespace isoscope {

namespace {

/// Those of the operations, and the angles: multiplied by one rounded factor, which the call parser knows.
const std::vector<ElementaryFunction>& functions() {
    static const auto all = [] {
        std::vector<ElementaryFunction> list{{"degrees", 1, Operation::multiply},
                                             {"radians", 1, Operation::multiply}};
        for (int i = 0; i < operationCount; ++i) {
            const auto operation = static_cast<Operation>(i);
            const OperationFacts& facts = factsOf(operation);
            if (facts.form != CallForm::none)
                list.push_back({facts.word(), facts.form == CallForm::plain ? facts.arity : 0, operation});
        }
        return list;
    }();
    return all;
}

}  // namespace

const ElementaryFunction* findElementaryFunction(std::string_view name) {
    const auto known = std::ranges::find(functions(), name, &ElementaryFunction::name);
    return known == functions().end() ? nullptr : &*known;
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
