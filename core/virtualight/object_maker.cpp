// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/virtualight/object_maker.h"

#include <algorithm>

#include "core/shapes/isosurface/isosurface.h"
#include "core/shapes/solids/box.h"
#include "core/virtualight/grids.h"
#include "core/virtualight/primitive_shape.h"

namespace isoscope::virtualight {

namespace {

CsgOperation operationOf(SetOperation operation) {
    switch (operation) {
        case SetOperation::merge: return CsgOperation::merge;
        case SetOperation::intersection: return CsgOperation::intersection;
        case SetOperation::difference: return CsgOperation::difference;
        default: return CsgOperation::union_;
    }
}

void clipBy(ObjectDescription& description, const ObjectPointer& clip) {
    Wrapping& wrapping = description.wrapping(*findWrappingModifier("clipped_by"));
    wrapping.on = true;
    wrapping.objects.push_back({clip, {}});
}

/// What drawing a primitive asks for: points that are kept, and evaluations of about fifty operations.
struct Cost {
    std::size_t points = 0;
    std::size_t work = 0;
};

std::size_t workPerPoint(const Function& function) { return function.graph->size() / 50 + 1; }

Cost costOf(const Primitive& primitive, const ShapeModifiers& modifiers) {
    const auto net = [](int a, int b) {
        return (static_cast<std::size_t>(a) + 1) * (static_cast<std::size_t>(b) + 1);
    };
    const std::array<int, 2> steps = modifiers.subdivision.value_or(std::array{defaultSteps, defaultSteps});
    const auto of = [](std::size_t points, std::size_t each) { return Cost{points, points * each}; };
    if (const auto* patch = std::get_if<BicubicShape>(&primitive))
        return of(net(patch->uSteps, patch->vSteps), 4);
    if (const auto* nurbs = std::get_if<NurbsShape>(&primitive)) {
        const int orders = nurbs->surface.u.order * nurbs->surface.v.order;
        return of(net(steps[0], steps[1]), static_cast<std::size_t>(8 + orders));
    }
    if (const auto* surface = std::get_if<ParametricShape>(&primitive)) {
        std::size_t each = 0;
        for (const Function& function : surface->functions) each += 5 * workPerPoint(function);
        return of(net(steps[0], steps[1]), each);
    }
    if (const auto* field = std::get_if<ImplicitPlanarField>(&primitive))
        return of(net(field->xSteps, field->zSteps), workPerPoint(field->height));
    if (const auto* field = std::get_if<ImplicitSphericalField>(&primitive))
        return of(net(field->uSteps, field->vSteps), workPerPoint(field->offset));
    if (const auto* field = std::get_if<ImageField>(&primitive))
        return of(net(field->raster.width, field->raster.height), 1);
    if (const auto* surface = std::get_if<ImplicitShape>(&primitive))
        return {0, gradientPoints * workPerPoint(surface->function)};
    return {};
}

}  // namespace

ObjectPointer ObjectMaker::make(const Node& node, const ShapeModifiers& outer) {
    if (context_.stopAsked()) return nullptr;
    const ShapeModifiers modifiers = node.modifiers.within(outer);
    if (node.primitive) return makePrimitive(node, modifiers);
    return makeParts(node, modifiers);
}

bool ObjectMaker::withinBudget(const Node& node, const ShapeModifiers& modifiers) {
    const Cost cost = costOf(*node.primitive, modifiers);
    points_ += cost.points;
    work_ += cost.work;
    if (points_ <= pointLimit && work_ <= workLimit) return true;
    points_ -= cost.points;
    work_ -= cost.work;
    context_.error(
        "too-large", node.range,
        "The surfaces of this text have too many points, or functions that are too long; this one is "
        "left out.",
        "give it fewer steps or subdivisions");
    return false;
}

ObjectPointer ObjectMaker::makePrimitive(const Node& node, const ShapeModifiers& modifiers) {
    std::vector<Drawn>& known = drawn_[&node];
    for (const Drawn& drawn : known)
        if (drawn.modifiers == modifiers) return drawn.object;
    if (!withinBudget(node, modifiers)) return nullptr;
    DrawnPrimitive drawn =
        drawPrimitive(*node.primitive, modifiers, context_.parameterTable, context_.options.stop);
    ObjectPointer object;
    if (drawn.shape) {
        ObjectDescription description;
        description.keyword = node.keyword;
        description.range = node.range;
        description.shape = drawn.shape;
        description.transform = drawn.place.then(transformOf(node.transforms));
        if (const auto surface = asIsosurface(drawn.shape)) {
            const int number = context_.isosurfaceCount++;
            description.isosurface =
                IsosurfaceStatement{surface,
                                    node.range,
                                    node.functionRange,
                                    std::string(context_.sources.slice(node.functionRange)),
                                    {},
                                    {},
                                    number};
        }
        object = std::make_shared<const ObjectDescription>(std::move(description));
    } else if (!context_.stopAsked()) {
        context_.error("not-drawn", node.range, drawn.problem, drawn.hint);
    }
    known.push_back({modifiers, object});
    return object;
}

ObjectPointer ObjectMaker::placed(const Node& node, const ObjectPointer& object) {
    if (node.transforms.empty()) return object;
    const Transform transform = transformOf(node.transforms);
    ObjectDescription copy = *object;
    copy.transform = copy.transform.then(transform);
    for (Wrapping& wrapping : copy.wrappings)
        for (ClippingObject& part : wrapping.objects) part.transform = part.transform.then(transform);
    return std::make_shared<const ObjectDescription>(std::move(copy));
}

ObjectPointer ObjectMaker::makeParts(const Node& node, const ShapeModifiers& modifiers) {
    std::vector<ObjectPointer> parts;
    for (const NodePointer& part : node.parts) {
        ObjectPointer object = make(*part, modifiers);
        // Without one of its parts a solid would be another one.
        if (!object) return nullptr;
        parts.push_back(std::move(object));
    }
    ObjectDescription description;
    description.keyword = node.keyword;
    description.range = node.range;
    description.operation = operationOf(node.operation);
    const bool clipping = node.operation == SetOperation::clipping;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        description.shapeCount += parts[i]->shapeCount;
        description.depth = std::max(description.depth, parts[i]->depth + 1);
        if (clipping && i > 0)
            clipBy(description, parts[i]);
        else
            description.parts.push_back(parts[i]);
    }
    if (node.operation == SetOperation::inverse)
        description.wrapping(*findWrappingModifier("inverse")).on = true;
    if (node.modifiers.bound) {
        ObjectDescription room;
        room.keyword = "Bound";
        room.range = node.range;
        room.shape = std::make_shared<Box>((*node.modifiers.bound)[0], (*node.modifiers.bound)[1]);
        clipBy(description, std::make_shared<const ObjectDescription>(std::move(room)));
    }
    return placed(node, std::make_shared<const ObjectDescription>(std::move(description)));
}

}  // namespace isoscope::virtualight
