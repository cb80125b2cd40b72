// SPDX-License-Identifier: GPL-3.0-or-later
// `quadric`, `cubic`, `quartic` and `poly`.
#include <algorithm>
#include <cmath>

#include "core/language/expression_parser.h"
#include "core/language/parameter_collector.h"
#include "core/language/shape_parsers.h"
#include "core/shapes/poly.h"
#include "core/shapes/quadric.h"

namespace isoscope {

namespace {

/// "x2y" for x^2 y, of each term in the order of the language.
std::vector<std::string> termNames(int order) {
    std::vector<std::string> names;
    const auto power = [](const char* letter, int exponent) {
        return exponent == 0 ? std::string() : exponent == 1 ? letter : letter + std::to_string(exponent);
    };
    for (int x = order; x >= 0; --x)
        for (int y = order - x; y >= 0; --y)
            for (int z = order - x - y; z >= 0; --z) {
                const std::string name = power("x", x) + power("y", y) + power("z", z);
                names.push_back(name.empty() ? "constant" : name);
            }
    return names;
}

/// `< T1, T2, ... >`, which may be longer than any vector.
std::vector<double> parseCoefficients(ShapeReader& reader, int order) {
    TokenStream& tokens = reader.tokens();
    std::vector<double> coefficients;
    const std::size_t wanted = Poly::termCount(order);
    const SourceRange start = tokens.peek().range;
    if (!tokens.expect("<", "to begin the coefficients")) {
        reader.fail(start, "The coefficients of `" + reader.keyword() + "` stand between `<` and `>`.");
        return {};
    }
    const std::vector<std::string> names = termNames(order);
    ParameterCollector parameters(tokens.context());
    ExpressionParser expressions(tokens);
    while (expressions.atExpression()) {
        const SourceRange at = tokens.peek().range;
        coefficients.push_back(expressions.parseFloat());
        // A slider for each 0 would bury the others.
        if (coefficients.back() != 0 && coefficients.size() <= wanted)
            parameters.addShapeNumbers(reader.keyword(), names[coefficients.size() - 1],
                                       rangeSince(at, tokens));
        if (!tokens.accept(",")) break;
    }
    tokens.expect(">", "to close the coefficients");
    if (coefficients.size() != wanted)
        reader.fail(rangeSince(start, tokens), "A polynomial of order " + std::to_string(order) + " has " +
                                                   std::to_string(wanted) + " coefficients, but here are " +
                                                   std::to_string(coefficients.size()) + ".");
    const auto finite = [](double c) { return std::abs(c) < 1e300; };
    if (!std::all_of(coefficients.begin(), coefficients.end(), finite))
        reader.fail(rangeSince(start, tokens),
                    "The coefficients of `" + reader.keyword() + "` are not all finite.");
    return coefficients;
}

ShapePointer parseOfOrder(ShapeReader& reader, int order) {
    std::vector<double> coefficients = parseCoefficients(reader, order);
    bool sturm = false;
    reader.flag("sturm", sturm);
    if (reader.failed()) return nullptr;
    return std::make_shared<Poly>(order, std::move(coefficients));
}

}  // namespace

ShapePointer parseQuadric(ShapeReader& reader) {
    const glm::dvec3 squares = reader.vector("squares");
    const glm::dvec3 products = reader.vector("products");
    const glm::dvec3 linear = reader.vector("linear");
    const double constant = reader.number("constant");
    return std::make_shared<Quadric>(squares, products, linear, constant);
}

ShapePointer parseCubic(ShapeReader& reader) { return parseOfOrder(reader, 3); }
ShapePointer parseQuartic(ShapeReader& reader) { return parseOfOrder(reader, 4); }

ShapePointer parsePoly(ShapeReader& reader) {
    const int order = reader.count("order", 2, Poly::orderLimit);
    return parseOfOrder(reader, order);
}

}  // namespace isoscope
