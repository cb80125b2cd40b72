// SPDX-License-Identifier: GPL-3.0-or-later
// What follows the primitive of a Shape, or the expression of a Solid.
#include <glm/common.hpp>

#include "core/virtualight/document_parser.h"

namespace isoscope::virtualight {

namespace {

constexpr int subdivisionLimit = 2048;

}  // namespace

void DocumentParser::parseModifiers(Node& node) {
    while (tokens_.peek().kind != TokenKind::end && !tokens_.peek().is("]")) {
        const Token token = tokens_.peek();
        if (tokens_.accept(",") || tokens_.accept(";")) continue;
        if (token.kind != TokenKind::word) return;
        if (parseModifier(node)) continue;
        const DeclaredThing* thing = names_.find(token.text);
        if (PrimitiveParser::isPrimitive(token.text) ||
            (thing && std::holds_alternative<NodePointer>(*thing))) {
            context_.error("unexpected-token", token.range, "One Shape holds one primitive.",
                           "join several by `+` in a Solid");
            tokens_.next();
            if (tokens_.peek().is("(")) tokens_.skipItem();
            continue;
        }
        // Anything else is a shader, or its modifiers: by name, with arguments or as a structure.
        if (tokens_.peek(1).is("(") || tokens_.peek(1).is("[")) {
            skipOther();
        } else {
            tokens_.next();
            context_.report({Severity::leftOut,
                             "left-out",
                             token.range,
                             "`" + std::string(token.text) + "` is not simulated.",
                             "only shapes, solids, transformations and shape modifiers are drawn",
                             {}});
        }
    }
}

bool DocumentParser::parseModifier(Node& node) {
    if (parseTransform(node) || parseSolver(node)) return true;
    const Token word = tokens_.peek();
    if (tokens_.accept("Bound"))
        parseBound(node, word);
    else if (tokens_.accept("RenderBound"))
        parseRenderBound(node, word);
    else if (tokens_.accept("ShapeSubdivision") || tokens_.accept("ShapeSubdivisions"))
        parseSubdivision(node, word);
    else
        return false;
    return true;
}

bool DocumentParser::parseTransform(Node& node) {
    const Token word = tokens_.peek();
    TransformStep step;
    if (tokens_.accept("Rotate"))
        step.kind = TransformStep::Kind::rotate;
    else if (tokens_.accept("Translate"))
        step.kind = TransformStep::Kind::translate;
    else if (tokens_.accept("Scale"))
        step.kind = TransformStep::Kind::scale;
    else
        return false;
    ArgumentReader arguments(tokens_, names_, word);
    step.numbers.x = arguments.number("x");
    step.numbers.y = arguments.number("y");
    step.numbers.z = arguments.number("z");
    arguments.close();
    const bool flat = step.numbers.x == 0 || step.numbers.y == 0 || step.numbers.z == 0;
    if (step.kind == TransformStep::Kind::scale && flat && !arguments.failed())
        context_.warning("zero-scale", tokens_.rangeFrom(word.range),
                         "A factor of 0 in `Scale` counts as 1.");
    if (!arguments.failed()) node.transforms.push_back(step);
    return true;
}

bool DocumentParser::parseSolver(Node& node) {
    const Token word = tokens_.peek();
    if (tokens_.accept("FerrariSolver"))
        node.modifiers.solver = Solver::ferrari;
    else if (tokens_.accept("VietaSolver"))
        node.modifiers.solver = Solver::vieta;
    else if (tokens_.accept("SturmSolver"))
        node.modifiers.solver = Solver::sturm;
    else
        return false;
    const auto* polynomial = node.primitive ? std::get_if<PolynomialShape>(&*node.primitive) : nullptr;
    if (polynomial && polynomial->order > 4 && node.modifiers.solver != Solver::sturm)
        context_.note("solver", word.range,
                      "`" + std::string(word.text) + "` is for order 4 at most, and this surface has order " +
                          std::to_string(polynomial->order) + ": `SturmSolver` draws it.");
    return true;
}

void DocumentParser::parseBound(Node& node, const Token& word) {
    ArgumentReader arguments(tokens_, names_, word);
    const glm::dvec3 first = arguments.point("first corner");
    const glm::dvec3 second = arguments.point("second corner");
    if (!arguments.failed() && (first.x == second.x || first.y == second.y || first.z == second.z))
        arguments.fail(tokens_.rangeFrom(word.range), "The corners of a Bound must differ in x, y and z.");
    arguments.close();
    if (!arguments.failed()) node.modifiers.bound = {glm::min(first, second), glm::max(first, second)};
}

void DocumentParser::parseRenderBound(Node& node, const Token& word) {
    ArgumentReader arguments(tokens_, names_, word);
    std::array<double, 4> domain{};
    static constexpr const char* what[] = {"least u", "greatest u", "least v", "greatest v"};
    for (std::size_t k = 0; k < 4; ++k) domain[k] = arguments.number(what[k]);
    if (!arguments.failed() && (domain[0] >= domain[1] || domain[2] >= domain[3]))
        arguments.fail(tokens_.rangeFrom(word.range),
                       "The limits of a RenderBound go from the lesser to the greater one.",
                       "their order is umin, umax, vmin, vmax");
    arguments.close();
    if (!arguments.failed()) node.modifiers.renderBound = domain;
}

void DocumentParser::parseSubdivision(Node& node, const Token& word) {
    ArgumentReader arguments(tokens_, names_, word);
    std::array<int, 2> steps{};
    steps[0] = steps[1] = arguments.count("subdivision", 1, subdivisionLimit);
    if (!arguments.failed() && tokens_.peek().is(","))
        steps[1] = arguments.count("subdivision in v", 1, subdivisionLimit);
    // The text does not say what a third number is for.
    const bool third = !arguments.failed() && tokens_.peek().is(",");
    if (third) {
        arguments.count("third subdivision", 1, subdivisionLimit);
        context_.report({Severity::leftOut,
                         "left-out",
                         arguments.range(),
                         "The third number of `" + std::string(word.text) + "` is not simulated.",
                         "the first two are the steps in u and v",
                         {}});
    }
    arguments.close();
    if (!arguments.failed()) node.modifiers.subdivision = steps;
}

}  // namespace isoscope::virtualight
