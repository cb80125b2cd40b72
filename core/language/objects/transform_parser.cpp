// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/objects/transform_parser.h"

#include <array>
#include <cmath>

#include "core/language/expressions/declared_value.h"
#include "core/language/expressions/expression_parser.h"

namespace isoscope {

bool TransformParser::parseModifier(Transform& transform) {
    const Token& word = tokens_.peek();
    if (word.kind != TokenKind::word) return false;
    if (tokens_.accept("translate"))
        transform = transform.then(Transform::translation(ExpressionParser(tokens_).parseVector()));
    else if (tokens_.accept("rotate"))
        transform = transform.then(Transform::rotation(ExpressionParser(tokens_).parseVector()));
    else if (tokens_.accept("scale"))
        transform = transform.then(parseScale());
    else if (tokens_.accept("matrix"))
        transform = transform.then(parseMatrix());
    else if (tokens_.accept("transform"))
        transform = transform.then(parseTransform());
    else
        return false;
    return true;
}

Transform TransformParser::parseScale() {
    const SourceRange start = tokens_.peek().range;
    const glm::dvec3 factors = ExpressionParser(tokens_).parseVector();
    if (factors.x == 0 || factors.y == 0 || factors.z == 0)
        tokens_.context().warning("zero-scale", start, "A factor of 0 in `scale` counts as 1.");
    return Transform::scaling(factors);
}

Transform TransformParser::parseMatrix() {
    const SourceRange start = tokens_.peek().range;
    std::array<double, 12> numbers{};
    bool complete = true;
    if (!tokens_.expect("<", "to begin the 12 numbers of `matrix`")) return {};
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        if (k > 0 && !tokens_.accept(",") && tokens_.peek().is(">")) {
            tokens_.context().error("short-matrix", start, "`matrix` takes 12 numbers.");
            complete = false;
            break;
        }
        // The arguments of a comparison would take the closing `>` for an operator; parseNumber stops before
        // it.
        numbers[k] = ExpressionParser(tokens_).parseFloat();
    }
    if (!tokens_.expect(">", "to close the numbers of `matrix`") || !complete) return {};
    glm::dmat4 m(1);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 3; ++column)
            m[row][column] = numbers[static_cast<std::size_t>(3 * row + column)];
    const Transform result = Transform::matrix(m);
    if (result.singular())
        tokens_.context().error("singular-matrix", start,
                                "This `matrix` flattens everything; it cannot be used.");
    return result;
}

bool TransformParser::appendDeclared(Transform& transform) {
    const std::optional<Transform> declared = takeDeclared<Transform>(tokens_);
    if (declared) transform = transform.then(*declared);
    return declared.has_value();
}

Transform TransformParser::parseTransform() {
    Transform result;
    if (tokens_.accept("{")) return parseBlock();
    if (!appendDeclared(result))
        tokens_.context().error("unexpected-token", tokens_.peek().range,
                                "Expected `{` or the name of a declared transform behind `transform`.");
    return result;
}

Transform TransformParser::parseBlock() {
    Transform result;
    bool inverse = false;
    while (!tokens_.accept("}")) {
        if (tokens_.accept("inverse"))
            inverse = true;
        else if (!parseModifier(result) && !appendDeclared(result)) {
            const Token& token = tokens_.peek();
            if (token.kind == TokenKind::end) {
                tokens_.expect("}", "to close `transform`");
                break;
            }
            tokens_.context().error(
                "unexpected-token", token.range,
                "Expected `translate`, `rotate`, `scale`, `matrix`, `inverse` or a declared transform here.");
            tokens_.skipBlock();
            break;
        }
    }
    return inverse ? result.inverse() : result;
}

}  // namespace isoscope
