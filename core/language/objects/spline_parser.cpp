// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/objects/spline_parser.h"

#include <algorithm>

#include "core/language/expressions/declared_value.h"
#include "core/language/expressions/expression_parser.h"
#include "core/language/scene_draft.h"

namespace isoscope {

std::optional<SplineType> SplineParser::acceptType() {
    if (tokens_.accept("linear_spline")) return SplineType::linear;
    if (tokens_.accept("quadratic_spline")) return SplineType::quadratic;
    if (tokens_.accept("cubic_spline")) return SplineType::cubic;
    if (tokens_.accept("natural_spline")) return SplineType::natural;
    return std::nullopt;
}

bool SplineParser::parsePoint() {
    Spline::Point point;
    point.place = ExpressionParser(tokens_).parseFloat();
    tokens_.accept(",");
    const SourceRange start = tokens_.peek().range;
    const std::optional<Value> value = ExpressionParser(tokens_).parseValue();
    const auto* vector = value ? std::get_if<VectorValue>(&value->data) : nullptr;
    const auto* number = value ? std::get_if<NumberValue>(&value->data) : nullptr;
    if (vector) {
        point.value = vector->components;
        components_ = std::max(components_, vector->count);
    } else if (number) {
        point.value.fill(number->value);
        components_ = std::max(components_, 2);
    } else {
        if (value)
            tokens_.context().error("expected-vector", rangeSince(start, tokens_),
                                    "The points of a spline are floats or vectors.");
        return false;
    }
    points_.push_back(point);
    tokens_.accept(",");
    return tokens_.charge(TokenStream::stepsPerNumber, start);
}

std::shared_ptr<const Spline> SplineParser::parse() {
    const SourceRange word = tokens_.lastRange();
    if (!tokens_.expect("{", "to begin `spline`")) return nullptr;
    SplineType type = SplineType::linear;
    if (const auto base = takeDeclared<std::shared_ptr<const Spline>>(tokens_); base && *base) {
        type = (*base)->type();
        if (!tokens_.charge((*base)->points().size() * TokenStream::stepsPerNumber, word)) return nullptr;
        points_ = (*base)->points();
        components_ = (*base)->components();
        tokens_.accept(",");
    }
    if (const std::optional<SplineType> given = acceptType()) type = *given;
    tokens_.accept(",");
    while (ExpressionParser(tokens_).atExpression())
        if (!parsePoint()) {
            tokens_.skipBlock();
            return nullptr;
        }
    if (!tokens_.expect("}", "or a point to go on with the spline")) {
        tokens_.skipBlock();
        return nullptr;
    }
    if (points_.empty()) {
        tokens_.context().error("bad-spline", word, "A spline needs at least one point.");
        return nullptr;
    }
    return std::make_shared<const Spline>(type, std::move(points_), components_);
}

Operand SplineParser::call(const std::shared_ptr<const Spline>& spline) {
    Operand nothing;
    nothing.failed = true;
    if (!tokens_.expect("(", "and the place on the spline")) return nothing;
    const double place = ExpressionParser(tokens_).parseFloat();
    std::optional<SplineType> type;
    if (tokens_.accept(",")) {
        type = acceptType();
        if (!type)
            tokens_.context().error(
                "unexpected-token", tokens_.peek().range,
                "Expected the type of spline, but found " + describe(tokens_.peek()) + ".");
    }
    tokens_.expect(")", "to close the arguments of the spline");
    VectorValue result;
    result.count = spline->components();
    if (type && *type != spline->type()) {
        if (!tokens_.charge(spline->points().size(), tokens_.lastRange())) return nothing;
        result.components = Spline(*type, spline->points(), spline->components()).at(place);
    } else {
        result.components = spline->at(place);
    }
    return Operand::of(result);
}

}  // namespace isoscope
