// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/expressions/object_queries.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/language/expressions/declared_value.h"
#include "core/language/scene_builder.h"

namespace isoscope {

/// Shapes of the objects that have been asked, which stay alive with them.
struct QueriedObjects {
    struct Entry {
        ObjectPointer object;
        ShapePointer shape;
    };
    std::map<const ObjectDescription*, Entry> entries;
};

namespace {

/// POV-Ray's extent of what is infinite.
constexpr double hugeExtent = 1e10;
/// Hits nearer than this are the place that the ray starts from.
constexpr double nearestHit = 1e-6;

Operand vectorOperand(const glm::dvec3& v) {
    VectorValue vector;
    vector.components = {v.x, v.y, v.z, 0, 0};
    return Operand::of(vector);
}

TraceContext tracingWith(const ParseContext& context) {
    TraceContext tracing(std::make_shared<const std::vector<double>>(context.parameterTable),
                         RootFinder::lipschitz);
    tracing.stop = context.options.stop;
    return tracing;
}

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

void markStructural(ParseContext& context, const ObjectDescription& object) {
    if (object.isosurface) context.markStructural(object.isosurface->shape->settings().function);
    for (const ObjectPointer& part : object.parts) markStructural(context, *part);
    for (const Wrapping& wrapping : object.wrappings)
        for (const ClippingObject& part : wrapping.objects) markStructural(context, *part.object);
}

bool ObjectQueries::knows(std::string_view name) {
    return name == "trace" || name == "inside" || name == "min_extent" || name == "max_extent";
}

Operand ObjectQueries::call(const Token& name) {
    Operand nothing;
    nothing.failed = true;
    if (!tokens_.accept("(") && !tokens_.expect("(", "and the arguments of `" + std::string(name.text) + "`"))
        return nothing;
    const ObjectPointer object = parseObject(name);
    const Operand result = answer(name, object);
    if (!tokens_.accept(")"))
        tokens_.expect(")", "to close the arguments of `" + std::string(name.text) + "`");
    return result;
}

Operand ObjectQueries::answer(const Token& name, const ObjectPointer& object) {
    if (name.is("trace")) return trace(name, object);
    if (name.is("inside")) return inside(name, object);
    return extent(name, object);
}

ObjectPointer ObjectQueries::parseObject(const Token& name) {
    const Token word = tokens_.peek();
    if (const std::optional<ObjectPointer> object = takeDeclared<ObjectPointer>(tokens_)) return *object;
    if (const auto opaque = takeDeclared<OpaqueValue>(tokens_)) {
        reportLeftOut(tokens_.context(), word.range, "`" + opaque->keyword + "` is not drawn yet.");
        return nullptr;
    }
    tokens_.context().error(
        "no-object", word.range,
        "`" + std::string(name.text) + "` asks for a declared object, but found " + describe(word) + ".");
    if (word.kind == TokenKind::word) tokens_.next();
    return nullptr;
}

ShapePointer ObjectQueries::shapeOf(const ObjectPointer& object) {
    std::shared_ptr<QueriedObjects>& known = tokens_.context().queriedObjects;
    if (!known) known = std::make_shared<QueriedObjects>();
    QueriedObjects::Entry& entry = known->entries[object.get()];
    if (!entry.shape) {
        Scene scratch;
        entry = {object, SceneBuilder(scratch).shape(*object)};
        tokens_.charge(object->shapeCount, object->range);
    }
    // Each question goes through the parts for their sliders.
    constexpr std::size_t partsPerStep = 32;
    tokens_.charge(object->shapeCount / partsPerStep, object->range);
    markStructural(tokens_.context(), *object);
    return entry.shape;
}

void ObjectQueries::pay(const Token& name, const TraceContext& context) {
    tokens_.charge(static_cast<std::size_t>(context.rays + context.evaluations / 4 + 8), name.range);
}

Operand ObjectQueries::trace(const Token& name, const ObjectPointer& object) {
    ExpressionParser expressions(tokens_);
    tokens_.accept(",");  // as everywhere, POV-Ray forgives missing commas
    const glm::dvec3 from = expressions.parseVector();
    tokens_.accept(",");
    const glm::dvec3 direction = expressions.parseVector();
    Hit hit;
    bool found = false;
    if (object && finite(from) && finite(direction)) {
        TraceContext context = tracingWith(tokens_.context());
        context.missMemory = false;
        const double length = glm::length(direction);
        context.nearLimit = nearestHit;
        const Ray ray{from, length > 0 ? direction / length : direction};
        NearestHit nearest;
        if (length > 0) shapeOf(object)->nearest(std::span(&ray, 1), context, std::span(&nearest, 1));
        found = nearest.found;
        hit = nearest.hit;
        pay(name, context);
    }
    // Nothing may be peeked at: the name may be new, or a macro's.
    const Token behind = tokens_.nextName();
    if (behind.is(")"))
        tokens_.pushBack(behind);
    else
        assignNormal(behind.is(",") ? tokens_.nextName() : behind, found ? hit.normal : glm::dvec3(0));
    return vectorOperand(found ? hit.point : glm::dvec3(0));
}

void ObjectQueries::assignNormal(const Token& word, const glm::dvec3& normal) {
    if (word.kind != TokenKind::word) {
        tokens_.context().error(
            "expected-name", word.range,
            "Expected the name that is given the normal, but found " + describe(word) + ".");
        return;
    }
    const Value value{vectorOperand(normal).vector};
    SymbolTable& symbols = tokens_.context().symbols;
    if (Value* known = symbols.find(word.text))
        *known = value;
    else
        symbols.declare(std::string(word.text), value);
}

Operand ObjectQueries::inside(const Token& name, const ObjectPointer& object) {
    tokens_.accept(",");
    const glm::dvec3 point = ExpressionParser(tokens_).parseVector();
    if (!object || !finite(point)) return Operand::number(0);
    TraceContext context = tracingWith(tokens_.context());
    const bool contained = shapeOf(object)->contains(point, context);
    pay(name, context);
    return Operand::number(contained ? 1 : 0);
}

Operand ObjectQueries::extent(const Token& name, const ObjectPointer& object) {
    if (!object) return vectorOperand(glm::dvec3(0));
    const Bounds bounds = shapeOf(object)->bounds();
    glm::dvec3 corner = name.is("min_extent") ? bounds.low : bounds.high;
    for (int axis = 0; axis < 3; ++axis) corner[axis] = std::clamp(corner[axis], -hugeExtent, hugeExtent);
    pay(name, {});
    return vectorOperand(corner);
}

}  // namespace isoscope
