// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/expressions/operand.h"

namespace isoscope {

Operand Operand::number(double value) {
    Operand operand;
    operand.vector.components[0] = value;
    return operand;
}

Operand Operand::text(std::string value) {
    Operand operand;
    operand.isString = true;
    operand.string = std::move(value);
    return operand;
}

Operand Operand::of(const VectorValue& vector) {
    Operand operand;
    operand.vector = vector;
    return operand;
}

std::string Operand::kind() const {
    if (isString) return "a string";
    if (vector.count == 1) return "a float";
    return vector.color ? "a color" : "a vector";
}

Value toValue(const Operand& operand) {
    if (operand.isString) return {operand.string};
    if (operand.vector.count == 1) return {NumberValue{operand.value(), operand.parameter}};
    return {operand.vector};
}

std::optional<Operand> toOperand(const Value& value) {
    if (const auto* number = std::get_if<NumberValue>(&value.data)) {
        Operand operand = Operand::number(number->value);
        operand.parameter = number->parameter;
        return operand;
    }
    if (const auto* vector = std::get_if<VectorValue>(&value.data)) return Operand::of(*vector);
    if (const auto* string = std::get_if<std::string>(&value.data)) return Operand::text(*string);
    return std::nullopt;
}

VectorValue widened(const VectorValue& vector, int count) {
    VectorValue result = vector;
    if (vector.count == 1)
        for (std::size_t i = 1; i < static_cast<std::size_t>(count); ++i)
            result.components[i] = vector.components[0];
    else
        for (auto i = static_cast<std::size_t>(vector.count); i < result.components.size(); ++i)
            result.components[i] = 0;
    result.count = count;
    return result;
}

std::optional<int> componentIndex(std::string_view member) {
    if (member == "x" || member == "u" || member == "red") return 0;
    if (member == "y" || member == "v" || member == "green") return 1;
    if (member == "z" || member == "blue") return 2;
    if (member == "t" || member == "filter") return 3;
    if (member == "transmit") return 4;
    return std::nullopt;
}

}  // namespace isoscope
