// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/textures/object_pattern.h"

#include <algorithm>

#include "core/function/graph_builder.h"
#include "core/language/expressions/object_queries.h"
#include "core/language/objects/object_parser.h"
#include "core/language/scene_builder.h"
#include "core/shapes/solids/box.h"
#include "core/shapes/solids/plane.h"
#include "core/shapes/solids/sphere.h"
#include "core/texture/tables/object_table.h"

namespace isoscope {

namespace {

using Point = std::array<Expression, 3>;

Point moved(const glm::dmat4& m, const Point& p) {
    Point result;
    for (int row = 0; row < 3; ++row)
        result[static_cast<std::size_t>(row)] =
            p[0] * m[0][row] + p[1] * m[1][row] + p[2] * m[2][row] + m[3][row];
    return result;
}

Expression fieldAt(const Point& p, const Sphere& sphere) {
    const glm::dvec3& c = sphere.center();
    return sq(p[0] - c.x) + sq(p[1] - c.y) + sq(p[2] - c.z) - sphere.radius() * sphere.radius();
}

Expression fieldAt(const Point& p, const Box& box) {
    Expression field = max(box.low().x - p[0], p[0] - box.high().x);
    field = max(field, max(box.low().y - p[1], p[1] - box.high().y));
    return max(field, max(box.low().z - p[2], p[2] - box.high().z));
}

Expression fieldAt(const Point& p, const Plane& plane) {
    const glm::dvec3& n = plane.normal();
    return n.x * p[0] + n.y * p[1] + n.z * p[2] - plane.distance();
}

/// The field of a primitive at a point: negative inside. Nothing where it has no simple formula.
std::optional<Expression> fieldAt(const Point& p, const PrimitivePointer& primitive) {
    std::optional<Expression> field;
    primitive.visit<Sphere, Box, Plane>([&](const auto& known) { field = fieldAt(p, known); });
    return field;
}

std::optional<Expression> fieldOf(const ObjectDescription& object, const Point& outer) {
    const Wrapping* inverse = object.wrapping("inverse");
    const auto changes = [&](const Wrapping& wrapping) { return wrapping.on && &wrapping != inverse; };
    if (std::ranges::any_of(object.wrappings, changes) || object.isosurface) return std::nullopt;
    const Point p = moved(object.transform.backward(), outer);
    std::optional<Expression> field;
    if (object.shape) {
        field = fieldAt(p, object.shape->primitive());
    } else {
        const bool joins =
            object.operation == CsgOperation::union_ || object.operation == CsgOperation::merge;
        for (const ObjectPointer& part : object.parts) {
            std::optional<Expression> next = fieldOf(*part, p);
            if (!next) return std::nullopt;
            if (field && object.operation == CsgOperation::difference) next = -*next;
            field = !field ? *next : joins ? min(*field, *next) : max(*field, *next);
        }
    }
    if (field && inverse && inverse->on) field = -*field;
    return field;
}

/// Of objects without a simple formula the shape itself is asked.
NodeId insideNode(FunctionGraph& graph, const ObjectDescription& object, const Point& p,
                  ParseContext& context) {
    markStructural(context, object);
    Scene materials;
    CrackleSettings settings;
    settings.table = std::make_shared<const ObjectTable>(
        SceneBuilder(materials).shape(object),
        std::make_shared<const std::vector<double>>(context.parameterTable));
    return graph.crackle(settings, p[0].node(), p[1].node(), p[2].node());
}

}  // namespace

std::optional<Function> parseInsideFunction(TokenStream& tokens) {
    if (!tokens.expect("{", "to begin `object`")) return std::nullopt;
    SceneDraft draft;
    const Token word = tokens.peek();
    ObjectPointer object;
    if (word.kind == TokenKind::word && ObjectParser::isObject(word.text))
        object = ObjectParser(tokens, draft).parse();
    else if (const Value* value =
                 word.kind == TokenKind::word ? tokens.context().symbols.find(word.text) : nullptr)
        if (const auto* declared = std::get_if<ObjectPointer>(&value->data)) {
            object = *declared;
            tokens.next();
        }
    if (!object) {
        tokens.skipBlock();
        return std::nullopt;
    }
    FunctionGraph graph;
    Point point;
    for (int k = 0; k < 3; ++k) point[static_cast<std::size_t>(k)] = Expression(graph, graph.variable(k));
    const std::optional<Expression> field = fieldOf(*object, point);
    const NodeId result = field ? select(*field, field->number(1), field->number(0)).node()
                                : insideNode(graph, *object, point, tokens.context());
    return finish(std::move(graph), {result}, 3);
}

}  // namespace isoscope
