// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "core/language/expressions/operand.h"
#include "core/language/tokens/token_stream.h"

namespace isoscope {

/// An element of an array: shares the array, so that a value can be stored there.
struct ElementPlace {
    std::shared_ptr<ArrayValue> array;
    std::size_t element = 0;

    /// `array` must not be null, and `element` lie within it.
    Value& value() const { return array->elements[element]; }
};

/// Float, vector, colour and string expressions of the scene language, evaluated as they are read
/// (docs/language.md, "Expressions", says what real scenes use). On a mistake a diagnostic is reported, the
/// tokens already taken stay taken, and the result is empty or a neutral value; nothing throws.
///
/// As in POV-Ray, comparisons, `&`, `|` and `?:` need parentheses around them, because `<` and `>` also
/// enclose vectors. `=`, `<=`, `>=` and `!=` have a tolerance of 1e-10.
///
/// A declared number that is used here can only be followed by a new parse, so its parameter loses its slot
/// (ParseContext::markStructural); NumberValue::parameter keeps its index all the same.
class ExpressionParser {
  public:
    explicit ExpressionParser(TokenStream& tokens) : tokens_(tokens) {}

    /// Any expression: number, vector, colour or string.
    std::optional<Value> parseValue();
    /// A float; 0 after a mistake.
    NumberValue parseNumber();
    double parseFloat() { return parseNumber().value; }
    bool parseBool() { return parseFloat() != 0; }
    /// What stands behind a flag that takes no value in POV-Ray, which is warned of; true where nothing does.
    bool parseBareFlag(std::string_view flag);
    /// A vector; a float stands for the same value on all axes.
    glm::dvec3 parseVector();
    /// `color`, `rgb`, `rgbf`, `rgbt`, `rgbft`, `red 1 green ...`, a declared colour, or a bare vector.
    Color parseColor();
    std::string parseString();
    /// Whether the token at hand can begin an expression.
    bool atExpression();

    /// A float with comparisons and `&`, `|`, `?:` allowed, as between the parentheses of `#if ( ... )`.
    double parseCondition();
    /// `(NAME)` or `(NAME[i])` behind `defined` or `#ifdef` (named in messages by `what`): whether it has a
    /// value. Nothing may have been peeked at.
    bool parseDefined(const std::string& what);
    /// The value of a `#declare`: like parseValue, but a mere copy of a declared number keeps its slot. See
    /// ValueReader::read for `literal`.
    std::optional<Value> parseDeclared(std::optional<SourceRange>* literal);
    /// The same where the first operand, an array's element, has been read already.
    std::optional<Value> parseDeclaredBehind(const Value& first);
    /// `[i][j]...` behind the name of an array.
    std::optional<ElementPlace> parseElementPlace(std::shared_ptr<ArrayValue> array);
    /// The component that `x`, `red`, ... names, behind `.`.
    std::optional<int> parseComponentName();

    /// Says that a word is not declared, with a likely one for a hint.
    void reportUnknown(const Token& word);
    /// Where a comparison, `&`, `|` or `?` follows a value that has no parentheses around it: says that they
    /// are missing.
    bool reportBareComparison();
    /// Whether a value is a float, vector, colour or string.
    static bool isExpressionValue(const Value& value);

  private:
    friend class FunctionCaller;

    Operand full();
    Operand logical();
    Operand relation();
    Operand sum();
    Operand product();
    Operand unary();
    Operand primary();
    Operand withMembers(Operand operand);
    Operand parenthesised();
    Operand vectorLiteral();
    Operand word();
    Operand declared(const Token& name, Value* value);
    Operand call(const Token& name, const FunctionValue& function);
    Operand colorExpression();
    /// From sRGB to the colours of the scene.
    void decodeStored(const Token& keyword, VectorValue& color);
    void applyColorKeyword(const Token& keyword, const Operand& value, VectorValue& color);
    bool atColor();

    /// The operands of + - * / | & and comparisons: strings are refused, parameters lose their slots.
    void consume(Operand& operand);
    Operand fail(std::string id, const SourceRange& range, std::string message, std::string hint = {});
    double floatOf(Operand operand, const SourceRange& range);
    SourceRange rangeFrom(const SourceRange& begin) const;
    ParseContext& context() { return tokens_.context(); }

    TokenStream& tokens_;
    std::optional<Operand> first_;  ///< an operand that has been read ahead of the expression
};

}  // namespace isoscope
