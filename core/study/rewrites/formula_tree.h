// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/source_text.h"

namespace isoscope {

/// A part of a formula as it stands in the text: which operator or call, and where.
struct FormulaPart {
    /// What the part is by its outermost operation.
    enum class Kind : std::uint8_t {
        number,  ///< a literal
        name,    ///< a variable or a declared number, `.member` included
        call,    ///< `head` is the function
        sign,    ///< `head` is + or -
        binary,  ///< `head` is the operator
    };
    Kind kind = Kind::number;
    std::string head;   ///< the word, literal or operator
    SourceRange range;  ///< parentheses around it included
    SourceRange inner;  ///< without them
    std::vector<std::shared_ptr<const FormulaPart>> parts;

    /// Whether it is this operator between two operands, or a call of this function.
    bool isBinary(std::string_view sign) const { return kind == Kind::binary && head == sign; }
    bool isCall(std::string_view name) const { return kind == Kind::call && head == name; }
    /// A number, or a name: what the interpreter reads without a step.
    bool simple() const { return kind == Kind::number || kind == Kind::name; }
};
using FormulaPointer = std::shared_ptr<const FormulaPart>;

/// Reads bytes [begin, end) of `text`, which is text number `file`: what stands between the braces of
/// `function { }`. Null for what is not a plain formula: directives, strings, patterns, mistakes; and for
/// formulas of more than 2000 operations or nested deeper than 200.
FormulaPointer readFormula(std::string_view text, const SourceRange& range);

/// The part without blanks and comments and needless parentheses around it, for comparing.
std::string canonicalText(const FormulaPart& part);
/// Processor nanoseconds that POV-Ray 3.7 takes for it in one evaluation, on the machine of
/// core/study/accuracy/povray_time.h, as the interpreter does it: twice for what stands there twice. Products
/// of two compound factors count 105 and pow 28, 50 for exponents that are not multiplied out, timed with
/// 3.7.0.10; calls of functions of the text, 41, without what they do.
double interpreterTime(const FormulaPart& part);

}  // namespace isoscope
