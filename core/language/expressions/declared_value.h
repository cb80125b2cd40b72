// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>

#include "core/language/expressions/expression_parser.h"

namespace isoscope {

/// Takes the name of a declared value of type T, or an element of an array of such values (`Textures[2]`), if
/// that comes next. Anything else stays where it is.
template <class T>
std::optional<T> takeDeclared(TokenStream& tokens) {
    const Token& name = tokens.peek();
    if (name.kind != TokenKind::word) return std::nullopt;
    const Value* value = tokens.context().symbols.find(name.text);
    if (!value) return std::nullopt;
    if (const T* declared = valueAs<T>(*value)) {
        const T copy = *declared;
        tokens.next();
        return copy;
    }
    const auto* array = std::get_if<std::shared_ptr<ArrayValue>>(&value->data);
    if (!array || !*array) return std::nullopt;
    const auto holds = [](const Value& element) { return valueAs<T>(element) != nullptr; };
    const std::shared_ptr<ArrayValue> elements = *array;
    if (std::none_of(elements->elements.begin(), elements->elements.end(), holds)) return std::nullopt;
    tokens.next();
    const std::optional<ElementPlace> place = ExpressionParser(tokens).parseElementPlace(elements);
    if (!place) return T();
    if (const T* declared = valueAs<T>(place->value())) return *declared;
    if (const auto* opaque = std::get_if<OpaqueValue>(&place->value().data))
        tokens.context().report({Severity::leftOut,
                                 "left-out",
                                 tokens.lastRange(),
                                 "`" + opaque->keyword + "` is not simulated.",
                                 {},
                                 {}});
    else
        tokens.context().error("wrong-element", tokens.lastRange(),
                               "This element of the array is of another kind.");
    return T();
}

}  // namespace isoscope
