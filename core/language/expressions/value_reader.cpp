// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/expressions/value_reader.h"

#include "core/language/expressions/expression_parser.h"
#include "core/language/objects/spline_parser.h"
#include "core/language/tokens/nesting_guard.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/language/tokens/token_stream_state.h"
#include "core/text/number_format.h"

namespace isoscope {

std::optional<Value> ValueReader::read(std::optional<SourceRange>* literal) {
    const NestingGuard guard(tokens_);
    if (!guard.ok()) return std::nullopt;
    ParseContext& context = tokens_.context();
    const Token& first = tokens_.peek();
    if (first.is("array")) return readArray();
    ExpressionParser expressions(tokens_);
    if (first.kind == TokenKind::word)
        if (const Value* named = context.symbols.find(first.text)) return readNamed(first, *named, literal);
    if (expressions.atExpression()) return paid(expressions.parseDeclared(literal));
    const Token found = first;
    if (found.kind == TokenKind::word && tokens_.state_->valueParser) {
        const TokenStream::ValueParser parse = tokens_.state_->valueParser;
        if (std::optional<Value> value = parse(tokens_)) return value;
        if (tokens_.cutOff() || tokens_.peek().range != found.range) return std::nullopt;
    }
    if (found.kind == TokenKind::word) {
        expressions.reportUnknown(tokens_.next());
        // `Sphare { ... }`: its block means nothing without it.
        if (tokens_.accept("{")) tokens_.skipBlock();
    } else {
        context.error("expected-value", found.range,
                      found.kind == TokenKind::end
                          ? std::string("Expected a value, but the statement ends here.")
                          : "Expected a value, but found `" + std::string(found.text.substr(0, 40)) + "`.");
    }
    return std::nullopt;
}

std::optional<Value> ValueReader::readNamed(const Token& name, const Value& value,
                                            std::optional<SourceRange>* literal) {
    ExpressionParser expressions(tokens_);
    if (ExpressionParser::isExpressionValue(value)) return paid(expressions.parseDeclared(literal));
    const bool array = std::holds_alternative<std::shared_ptr<ArrayValue>>(value.data);
    const bool function = std::holds_alternative<FunctionValue>(value.data) ||
                          std::holds_alternative<std::shared_ptr<const Spline>>(value.data);
    if (!array && !function) {
        // Reading on may change what `value` refers to.
        std::optional<Value> copy = value;
        tokens_.next();
        return copy;
    }
    // An element or a call is an expression; the bare name is the array or the function.
    const Token word = name;
    const Value whole = value;
    tokens_.next();
    const bool used = tokens_.peek().is(array ? "[" : "(");
    if (!used) {
        if (!pay(whole)) return std::nullopt;
        return copyOf(whole);
    }
    if (array) {
        const auto place = expressions.parseElementPlace(std::get<std::shared_ptr<ArrayValue>>(whole.data));
        if (!place) return std::nullopt;
        const Value& element = place->value();
        if (std::holds_alternative<std::monostate>(element.data)) {
            tokens_.context().error(
                "unset-element", word.range,
                "This element of `" + std::string(word.text) + "` has not been given a value.");
            return std::nullopt;
        }
        if (const auto* spline = std::get_if<std::shared_ptr<const Spline>>(&element.data);
            spline && tokens_.peek().is("(")) {
            const Operand called = SplineParser(tokens_).call(std::shared_ptr<const Spline>(*spline));
            if (called.failed) return std::nullopt;
            return expressions.parseDeclaredBehind(Value{called.vector});
        }
        if (!ExpressionParser::isExpressionValue(element)) {
            if (!pay(element)) return std::nullopt;
            return copyOf(element);
        }
        return paid(expressions.parseDeclaredBehind(element));
    }
    tokens_.pushBack(word);
    return paid(expressions.parseDeclared(literal));
}

bool ValueReader::pay(const Value& value) {
    const ValueSize size = sizeOf(value);
    const std::size_t steps =
        size.elements * TokenStream::stepsPerElement + size.characters / TokenStream::charactersPerStep;
    return steps == 0 || tokens_.charge(steps, tokens_.lastRange());
}

std::optional<Value> ValueReader::paid(std::optional<Value> value) {
    if (value && !pay(*value)) value.reset();
    return value;
}

std::optional<Value> ValueReader::readArray() {
    const Token keyword = tokens_.next();
    auto array = std::make_shared<ArrayValue>();
    ParseContext& context = tokens_.context();
    constexpr std::size_t dimensionLimit = 5;
    constexpr int sizeLimit = 1'000'000'000;
    std::size_t count = 1;
    while (tokens_.accept("[")) {
        const double size = ExpressionParser(tokens_).parseFloat();
        tokens_.expect("]", "to close the size of the array");
        if (size > sizeLimit) {
            context.error("bad-array", tokens_.lastRange(),
                          "An array of " + shortestNumber(size) + " elements is too large; the most is " +
                              std::to_string(sizeLimit) + ".");
            return std::nullopt;
        }
        if (!(size >= 1) || array->dimensions.size() == dimensionLimit) {
            context.error("bad-array", tokens_.lastRange(),
                          "An array has 1 to 5 dimensions, each with at least 1 element.");
            return std::nullopt;
        }
        array->dimensions.push_back(static_cast<int>(size));
        count *= static_cast<std::size_t>(size);
        const SourceRange range = {keyword.range.file, keyword.range.begin, tokens_.lastRange().end};
        if (count > context.options.stepBudget) count = context.options.stepBudget;
        if (!tokens_.charge(count * TokenStream::stepsPerElement, range)) return std::nullopt;
    }
    if (tokens_.peek().is("mixed")) {
        context.error("not-read", tokens_.peek().range,
                      "Mixed arrays, which came with POV-Ray 3.8, are not read.",
                      "give the values of each kind an array of their own");
        return std::nullopt;
    }
    if (array->dimensions.empty()) {
        context.error("expected-token", tokens_.peek().range,
                      "Expected `[` and the size of the array behind `array`.");
        if (tokens_.accept("{")) tokens_.skipBlock();
        return std::nullopt;
    }
    array->elements.resize(count);
    std::size_t next = 0;
    if (tokens_.peek().is("{")) readElements(*array, 0, next);
    return Value{array};
}

bool ValueReader::readElements(ArrayValue& array, std::size_t dimension, std::size_t& next) {
    const NestingGuard guard(tokens_);
    if (!guard.ok() || !tokens_.expect("{", "to begin the elements of the array")) return false;
    const int size = array.dimensions[dimension];
    std::size_t stride = 1;
    for (std::size_t d = dimension + 1; d < array.dimensions.size(); ++d)
        stride *= static_cast<std::size_t>(array.dimensions[d]);
    const std::size_t begin = next;
    int i = 0;
    for (; i < size && !tokens_.peek().is("}"); ++i) {
        next = begin + static_cast<std::size_t>(i) * stride;
        if (dimension + 1 < array.dimensions.size()) {
            if (!readElements(array, dimension + 1, next)) break;
        } else {
            std::optional<Value> value = read();
            if (!value) break;
            if (const auto* number = std::get_if<NumberValue>(&value->data)) {
                tokens_.context().markStructural(number->parameter);
                value->data = NumberValue{number->value};
            }
            array.elements[next] = std::move(*value);
        }
        tokens_.accept(",");
    }
    if (tokens_.accept("}")) {
        if (i < size)
            warnOfRefusal(tokens_.context(), tokens_.lastRange(),
                          "wants all " + std::to_string(size) + " elements here.",
                          "add the missing ones, or set them one by one behind the declaration");
        return true;
    }
    const Token& found = tokens_.peek();
    tokens_.context().error("expected-token", found.range,
                            "Expected `}` to close the elements of the array, which has room for " +
                                std::to_string(size) + " here.");
    tokens_.skipBlock();
    return false;
}

}  // namespace isoscope
