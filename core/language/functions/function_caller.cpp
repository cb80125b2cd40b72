// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/functions/function_caller.h"

#include <algorithm>
#include <array>

#include "core/language/expressions/expression_functions.h"
#include "core/language/expressions/object_queries.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/language/tokens/words.h"

namespace isoscope {

namespace {

constexpr std::array<std::string_view, 3> reflection{"defined", "dimensions", "dimension_size"};
// Of transforms.inc, where they are macros.
constexpr std::array<std::string_view, 2> carrying{"vtransform", "vinv_transform"};

template <typename List>
bool contains(const List& list, std::string_view name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

struct Arity {
    std::size_t least = 0, most = 0;
};

Arity arityOf(std::string_view signature) {
    Arity arity;
    for (const char c : signature) {
        if (c == '?')
            --arity.least;
        else if (c == '*')
            --arity.least, arity.most = static_cast<std::size_t>(-1);
        else
            ++arity.least, ++arity.most;
    }
    return arity;
}

std::string plural(std::size_t count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string takes(const Token& name, const Arity& arity) {
    std::string text = "`" + std::string(name.text) + "` takes ";
    if (arity.most == static_cast<std::size_t>(-1)) text += "at least ";
    if (arity.least < arity.most && arity.most != static_cast<std::size_t>(-1))
        return text + std::to_string(arity.least) + " or " + plural(arity.most, "argument");
    return text + plural(arity.least, "argument");
}

}  // namespace

bool FunctionCaller::knows(std::string_view name) {
    return isWordFor(WordUse::expressionFunction, name) || contains(carrying, name);
}

std::vector<std::string> FunctionCaller::names() {
    std::vector<std::string> names(carrying.begin(), carrying.end());
    for (const Word& word : words())
        if (word.is(WordUse::expressionFunction)) names.emplace_back(word.text);
    return names;
}

Operand FunctionCaller::call(const Token& name) {
    if (name.is("defined")) return callDefined();
    if (contains(reflection, name.text)) return callDimensions(name);
    if (contains(carrying, name.text)) return callTransform(name);
    if (ObjectQueries::knows(name.text)) return ObjectQueries(tokens_).call(name);
    const ExpressionFunction& function = *findExpressionFunction(name.text);
    std::optional<std::vector<Operand>> read = arguments(name, function.signature);
    if (!read) return expressions_.fail({}, {}, {});
    return function.evaluate({tokens_, std::string(name.text), expressions_.rangeFrom(name.range),
                              std::move(*read), function.operation});
}

std::optional<std::vector<Operand>> FunctionCaller::arguments(const Token& name, std::string_view signature) {
    const Arity arity = arityOf(signature);
    // Most are there: what to say of the others need not be made up for each call.
    if (!tokens_.accept("(") && !tokens_.expect("(", "and the arguments of `" + std::string(name.text) + "`"))
        return std::nullopt;
    std::vector<Operand> read;
    std::size_t position = 0;
    while (read.size() < arity.most && !tokens_.peek().is(")") && tokens_.peek().kind != TokenKind::end) {
        const char kind = signature[position];
        if (position + 1 < signature.size() && signature[position + 1] != '*')
            position += signature[position + 1] == '?' ? 2 : 1;
        if (!argument(name, kind, read, arity.most == 1)) {
            skipArguments();
            return std::nullopt;
        }
        // POV-Ray forgives missing commas.
        if (!tokens_.accept(",") && !expressions_.atExpression()) break;
        if (tokens_.peek().is(")")) warnOfLastComma(tokens_);
    }
    if (read.size() < arity.least && expressions_.reportBareComparison()) {
        skipArguments();
        return std::nullopt;
    }
    if (read.size() < arity.least) {
        const std::size_t missing = arity.least - read.size();
        expressions_.fail("argument-count", name.range,
                          takes(name, arity) + "; " + std::to_string(missing) +
                              (missing == 1 ? " is missing." : " are missing."));
        skipArguments();
        return std::nullopt;
    }
    if (tokens_.accept(")")) return read;
    const bool more = expressions_.atExpression() || tokens_.peek().is(",");
    if (more && !tokens_.peek().is("<"))
        expressions_.fail("argument-count", tokens_.peek().range,
                          takes(name, arity) + "; expected `)` here.");
    else if (!expressions_.reportBareComparison())
        tokens_.expect(")", "to close the arguments of `" + std::string(name.text) + "`");
    skipArguments();
    return std::nullopt;
}

bool FunctionCaller::argument(const Token& name, char kind, std::vector<Operand>& arguments, bool single) {
    const SourceRange begin = tokens_.peek().range;
    // Where one argument stands alone its parentheses allow comparisons.
    Operand operand = kind == 's' ? expressions_.primary()
                      : single    ? expressions_.full()
                                  : expressions_.sum();
    if (operand.failed) return false;
    expressions_.context().markStructural(operand.parameter);
    const bool fits = kind == 's'   ? operand.isString
                      : kind == 'f' ? operand.isNumber()
                                    : !operand.isString && operand.vector.count <= (kind == 'w' ? 5 : 3);
    if (!fits) {
        const std::string wanted = kind == 's' ? "a string" : kind == 'f' ? "a float" : "a vector";
        expressions_.fail(kind == 's'   ? "expected-string"
                          : kind == 'f' ? "expected-float"
                                        : "expected-vector",
                          expressions_.rangeFrom(begin),
                          "Argument " + std::to_string(arguments.size() + 1) + " of `" +
                              std::string(name.text) + "` must be " + wanted + ", but this is " +
                              operand.kind() + ".");
        return false;
    }
    if (kind != 's' && kind != 'f') operand.vector = widened(operand.vector, kind == 'w' ? 5 : 3);
    arguments.push_back(std::move(operand));
    return true;
}

void FunctionCaller::skipArguments() {
    // A brace or semicolon means that the parenthesis was never closed.
    for (int depth = 1; depth > 0;) {
        const Token& token = tokens_.peek();
        if (token.kind == TokenKind::end || token.is("}") || token.is("{") || token.is(";")) return;
        depth += token.is("(") - token.is(")");
        tokens_.next();
    }
}

std::optional<std::vector<double>> FunctionCaller::floatArguments(const Token& name, int count) {
    const std::string signature(static_cast<std::size_t>(std::max(count, 0)), 'f');
    const auto read = arguments(name, signature);
    if (!read) return std::nullopt;
    std::vector<double> values;
    for (const Operand& operand : *read) values.push_back(operand.value());
    return values;
}

Operand FunctionCaller::callDefined() { return Operand::number(expressions_.parseDefined("`defined`")); }

Operand FunctionCaller::callDimensions(const Token& name) {
    if (!tokens_.expect("(", "and the arguments of `" + std::string(name.text) + "`"))
        return expressions_.fail({}, {}, {});
    const Token array = tokens_.next();
    const Value* value =
        array.kind == TokenKind::word ? expressions_.context().symbols.find(array.text) : nullptr;
    const auto* found = value ? std::get_if<std::shared_ptr<ArrayValue>>(&value->data) : nullptr;
    std::shared_ptr<ArrayValue> counted = found ? *found : nullptr;
    while (counted && tokens_.peek().is("[")) {
        const auto place = expressions_.parseElementPlace(counted);
        const auto* inner = place ? std::get_if<std::shared_ptr<ArrayValue>>(&place->value().data) : nullptr;
        counted = inner ? *inner : nullptr;
    }
    if (!counted) {
        expressions_.fail("no-array", array.range,
                          "`" + std::string(name.text) + "` asks for an array, but this is " +
                              (value ? kindOf(*value) : std::string("not declared")) + ".");
        skipArguments();
        return expressions_.fail({}, {}, {});
    }
    double result = static_cast<double>(counted->dimensions.size());
    if (name.is("dimension_size")) {
        tokens_.accept(",");
        const SourceRange at = tokens_.peek().range;
        const double dimension = expressions_.parseFloat();
        if (!(dimension >= 1 && dimension < result + 1)) {
            expressions_.fail("index-out-of-range", expressions_.rangeFrom(at),
                              "This array has " + plural(counted->dimensions.size(), "dimension") +
                                  "; expected 1 to " + std::to_string(counted->dimensions.size()) + ".");
            result = 0;
        } else {
            result = counted->dimensions[static_cast<std::size_t>(dimension) - 1];
        }
    }
    tokens_.expect(")", "to close the arguments of `" + std::string(name.text) + "`");
    return Operand::number(result);
}

Operand FunctionCaller::callTransform(const Token& name) {
    if (!tokens_.expect("(", "and the arguments of `" + std::string(name.text) + "`"))
        return expressions_.fail({}, {}, {});
    const glm::dvec3 vector = expressions_.parseVector();
    tokens_.accept(",");
    const Token transform = tokens_.next();
    const Value* value =
        transform.kind == TokenKind::word ? expressions_.context().symbols.find(transform.text) : nullptr;
    const auto* found = value ? valueAs<Transform>(*value) : nullptr;
    if (!found) {
        expressions_.fail("no-transform", transform.range,
                          "`" + std::string(name.text) + "` asks for a declared transform, but this is " +
                              (value ? kindOf(*value) : std::string("not declared")) + ".");
        if (!transform.is(")")) skipArguments();
        return expressions_.fail({}, {}, {});
    }
    const glm::dvec3 carried = (name.is("vtransform") ? *found : found->inverse()).point(vector);
    tokens_.expect(")", "to close the arguments of `" + std::string(name.text) + "`");
    VectorValue result;
    result.components = {carried.x, carried.y, carried.z, 0, 0};
    return Operand::of(result);
}

}  // namespace isoscope
