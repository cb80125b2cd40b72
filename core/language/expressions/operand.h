// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/language/expressions/value.h"

namespace isoscope {

/// An intermediate result of an expression: a string, or one to five numbers (one is a float).
struct Operand {
    VectorValue vector{{}, 1, false};
    bool isString = false;
    std::string string;
    int parameter = -1;                  ///< as NumberValue::parameter
    std::optional<SourceRange> literal;  ///< the number literal, sign included, when it is nothing else
    bool failed = false;                 ///< stands for something that was wrong and has been reported

    /// Results that are no parameter's and no literal's.
    static Operand number(double value);
    static Operand text(std::string value);
    static Operand of(const VectorValue& vector);

    /// Whether it is a float: one component. A vector or a colour is none.
    bool isNumber() const { return !isString && vector.count == 1; }
    /// The float; of a vector the first component, of a string 0.
    double value() const { return vector.components[0]; }
    /// "a float", "a vector", "a string"
    std::string kind() const;
};

/// The operand as the value of a name; a float keeps its parameter.
Value toValue(const Operand& operand);
/// The operand that a value of an expression's kind is; empty for a texture, a function, an array and so on.
std::optional<Operand> toOperand(const Value& value);

/// A float counts as that many equal components; a short vector is filled with zeros.
VectorValue widened(const VectorValue& vector, int count);

/// `combine` applied component by component after both sides have been brought to the same size, as POV-Ray
/// does.
template <typename Combine>
Operand combined(const Operand& a, const Operand& b, Combine combine) {
    const int count = a.vector.count > b.vector.count ? a.vector.count : b.vector.count;
    const VectorValue left = widened(a.vector, count), right = widened(b.vector, count);
    Operand result;
    result.vector.count = count;
    result.vector.color = left.color || right.color;
    result.failed = a.failed || b.failed;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        result.vector.components[i] = combine(left.components[i], right.components[i]);
    return result;
}

/// The number behind a name such as `x`, `red`, `t` or `transmit`; empty for other words.
std::optional<int> componentIndex(std::string_view member);

}  // namespace isoscope
