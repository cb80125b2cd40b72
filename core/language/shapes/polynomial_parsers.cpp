// SPDX-License-Identifier: GPL-3.0-or-later
// `quadric`, `cubic`, `quartic`, `poly` and `polynomial`.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/language/expressions/expression_parser.h"
#include "core/language/expressions/parameter_collector.h"
#include "core/language/objects/shape_parser.h"
#include "core/language/objects/shape_reader.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/shapes/solids/poly.h"
#include "core/shapes/solids/quadric.h"

namespace isoscope {

namespace {

/// "x2y" for x^2 y.
std::string termName(int x, int y, int z) {
    const auto power = [](const char* letter, int exponent) {
        return exponent == 0 ? std::string() : exponent == 1 ? letter : letter + std::to_string(exponent);
    };
    const std::string name = power("x", x) + power("y", y) + power("z", z);
    return name.empty() ? "constant" : name;
}

/// Of each term in the order of the language.
std::vector<std::string> termNames(int order) {
    std::vector<std::string> names;
    for (int x = order; x >= 0; --x)
        for (int y = order - x; y >= 0; --y)
            for (int z = order - x - y; z >= 0; --z) names.push_back(termName(x, y, z));
    return names;
}

/// `< T1, T2, ... >`, which may be longer than any vector; the commas may be left out.
std::vector<double> parseCoefficients(ShapeReader& reader, int order) {
    TokenStream& tokens = reader.tokens();
    std::vector<double> coefficients;
    const std::size_t wanted = Poly::termCount(order);
    const SourceRange start = tokens.peek().range;
    if (!tokens.accept("<")) {
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
        if (tokens.accept(",") && tokens.peek().is(">")) warnOfLastComma(tokens);
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

ShapePointer parseQuadric(ShapeReader& reader) {
    const glm::dvec3 squares = reader.vector("squares");
    const glm::dvec3 products = reader.vector("products");
    const glm::dvec3 linear = reader.vector("linear");
    const double constant = reader.number("constant");
    return std::make_shared<Quadric>(squares, products, linear, constant);
}

ShapePointer parseCubic(ShapeReader& reader) { return parseOfOrder(reader, 3); }
ShapePointer parseQuartic(ShapeReader& reader) { return parseOfOrder(reader, 4); }

/// The place of x^x y^y z^z among the terms of an order: all with a higher power of x come before it, then
/// those with a higher power of y.
std::size_t termIndex(int order, int x, int y, int z) {
    const int left = order - x, last = left - y;
    const auto n = [](int k) { return static_cast<std::size_t>(k); };
    const std::size_t before = x < order ? Poly::termCount(left - 1) : 0;
    return before + n(last) * n(last + 1) / 2 + n(last - z);
}

/// Behind `xyz`: `(power, power, power) : coefficient`.
bool parseTerm(ShapeReader& reader, int order, std::vector<double>& coefficients) {
    TokenStream& tokens = reader.tokens();
    const SourceRange start = tokens.lastRange();
    if (!tokens.expect("(", "and the powers of x, y and z behind `xyz`")) return false;
    // POV-Ray drops what is behind the point.
    const auto power = [&](const char* name) { return std::trunc(reader.number(name)); };
    const double x = power("power of x"), y = power("power of y"), z = power("power of z");
    if (!tokens.expect(")", "to close the powers")) return false;
    if (!(x >= 0 && y >= 0 && z >= 0 && x + y + z <= order)) {
        reader.fail(rangeSince(start, tokens),
                    "The powers of a term of this polynomial are not negative, and "
                    "their sum is at most " +
                        std::to_string(order) + ".");
        return false;
    }
    if (!tokens.expect(":", "and the coefficient behind the powers")) return false;
    const std::array<int, 3> powers{static_cast<int>(x), static_cast<int>(y), static_cast<int>(z)};
    coefficients[termIndex(order, powers[0], powers[1], powers[2])] =
        reader.number(termName(powers[0], powers[1], powers[2]));
    return true;
}

/// POV-Ray 3.7 reads it too: terms that are not stated are 0, of one that is stated twice the last counts.
ShapePointer parsePolynomial(ShapeReader& reader) {
    reader.allowLastCommas();
    const int order = reader.count("order", 2, Poly::orderLimit);
    std::vector<double> coefficients(Poly::termCount(order), 0.0);
    while (!reader.failed() && reader.tokens().accept("xyz"))
        if (!parseTerm(reader, order, coefficients)) return nullptr;
    bool sturm = false;
    reader.flag("sturm", sturm);
    if (reader.failed()) return nullptr;
    const auto finite = [](double c) { return std::abs(c) < 1e300; };
    if (!std::all_of(coefficients.begin(), coefficients.end(), finite)) {
        reader.fail(reader.keywordRange(), "The coefficients of `polynomial` are not all finite.");
        return nullptr;
    }
    return std::make_shared<Poly>(order, std::move(coefficients));
}

ShapePointer parsePoly(ShapeReader& reader) {
    const int order = reader.count("order", 2, Poly::orderLimit);
    return parseOfOrder(reader, order);
}

}  // namespace

std::span<const ShapeParser> polynomialParsers() {
    static constexpr std::array parsers{
        ShapeParser{.keyword = "quadric", .parse = parseQuadric},
        ShapeParser{.keyword = "cubic", .parse = parseCubic},
        ShapeParser{.keyword = "quartic", .parse = parseQuartic},
        ShapeParser{.keyword = "poly", .parse = parsePoly},
        ShapeParser{.keyword = "polynomial", .parse = parsePolynomial},
    };
    return parsers;
}

}  // namespace isoscope
