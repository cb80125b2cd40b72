// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/objects/shape_reader.h"

#include <algorithm>
#include <cmath>

#include "core/language/expressions/expression_parser.h"
#include "core/language/expressions/parameter_collector.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/language/tokens/words.h"

namespace isoscope {

double ShapeReader::number(const std::string& name) {
    const SourceRange start = tokens_.peek().range;
    const double value = ExpressionParser(tokens_).parseFloat();
    range_ = rangeSince(start, tokens_);
    ParameterCollector(tokens_.context()).addShapeNumbers(keyword(), name, range_);
    tokens_.charge(TokenStream::stepsPerNumber, range_);
    finite_ &= std::isfinite(value);
    parseComma();
    return value;
}

void ShapeReader::parseComma() {
    if (!tokens_.accept(",") || lastCommas_) return;
    const Token next = tokens_.peek();
    const bool ends = next.is("}") || (next.kind == TokenKind::word && isReservedWord(next.text));
    if (ends && !ExpressionParser(tokens_).atExpression()) warnOfLastComma(tokens_);
}

glm::dvec2 ShapeReader::pair(const std::string& name) {
    const auto c = components(name, 2);
    return {c[0], c[1]};
}

glm::dvec3 ShapeReader::vector(const std::string& name) {
    const auto c = components(name, 3);
    return {c[0], c[1], c[2]};
}

glm::dvec4 ShapeReader::quadruple(const std::string& name) {
    const auto c = components(name, 4);
    return {c[0], c[1], c[2], c[3]};
}

std::array<double, 5> ShapeReader::components(const std::string& name, int count) {
    const SourceRange start = tokens_.peek().range;
    const std::size_t complaints = tokens_.context().diagnostics.size();
    const std::optional<Value> value = ExpressionParser(tokens_).parseValue();
    range_ = rangeSince(start, tokens_);
    std::array<double, 5> result{};
    const auto* vector = value ? std::get_if<VectorValue>(&value->data) : nullptr;
    const auto* number = value ? std::get_if<NumberValue>(&value->data) : nullptr;
    if (number) result.fill(number->value);
    if (vector) {
        result = vector->components;
        if (vector->count > count)
            fail(range_, "Expected a vector of " + std::to_string(count) + " components, but this has " +
                             std::to_string(vector->count) + ".");
    }
    if (!vector && !number) {
        // What could not be understood has been complained about.
        if (value && tokens_.context().diagnostics.size() == complaints)
            fail(range_, "Expected a vector here.");
        failed_ = true;
    }
    ParameterCollector(tokens_.context()).addShapeNumbers(keyword(), name, range_);
    tokens_.charge(TokenStream::stepsPerNumber, range_);
    for (int k = 0; k < count; ++k) finite_ &= std::isfinite(result[static_cast<std::size_t>(k)]);
    parseComma();
    return result;
}

int ShapeReader::count(const std::string& name, int least, int most) {
    const SourceRange start = tokens_.peek().range;
    const double value = ExpressionParser(tokens_).parseFloat();
    range_ = rangeSince(start, tokens_);
    tokens_.accept(",");
    if (value >= least && value <= most) return static_cast<int>(value);
    fail(range_, "The " + name + " of `" + keyword() + "` must be " + std::to_string(least) + " to " +
                     std::to_string(most) + ".");
    return value > most ? most : least;
}

bool ShapeReader::flag(const char* word, bool& value) {
    if (!tokens_.accept(word)) return false;
    range_ = tokens_.lastRange();
    ExpressionParser expressions(tokens_);
    value = !expressions.atExpression() || expressions.parseBool();
    return true;
}

bool ShapeReader::opens(const std::string& part) {
    const bool opened = tokens_.expect("{", "to begin `" + part + "`");
    failed_ |= !opened;
    return opened;
}

void ShapeReader::fail(const SourceRange& range, const std::string& message, const std::string& hint) {
    if (!failed_) tokens_.context().error("bad-shape", range, message, hint);
    failed_ = true;
}

void ShapeReader::warn(const SourceRange& range, const std::string& message, const std::string& hint) {
    tokens_.context().warning("bad-shape", range, message, hint);
}

}  // namespace isoscope
