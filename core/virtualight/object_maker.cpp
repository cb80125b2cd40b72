// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/virtualight/object_maker.h"

#include <algorithm>

#include "core/shapes/box.h"
#include "core/shapes/isosurface.h"
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

std::size_t gridPointsOf(const Primitive& primitive, const ShapeModifiers& modifiers) {
    const auto net = [](std::size_t a, std::size_t b) { return (a + 1) * (b + 1); };
    const std::array<int, 2> steps = modifiers.subdivision.value_or(std::array{defaultSteps, defaultSteps});
    const auto s = [](int k) { return static_cast<std::size_t>(k); };
    if (const auto* patch = std::get_if<BicubicShape>(&primitive)) return net(s(patch->uSteps), s(patch->vSteps));
    if (std::holds_alternative<NurbsShape>(primitive)) return 4 * net(s(steps[0]), s(steps[1]));
    if (std::holds_alternative<ParametricShape>(primitive)) return 5 * net(s(steps[0]), s(steps[1]));
    if (const auto* field = std::get_if<ImplicitPlanarField>(&primitive))
        return net(s(field->xSteps), s(field->zSteps));
    if (const auto* field = std::get_if<ImplicitSphericalField>(&primitive))
        return net(s(field->uSteps), s(field->vSteps));
    if (const auto* field = std::get_if<ImageField>(&primitive))
        return net(s(field->raster.width), s(field->raster.height));
    return 0;
}

}  // namespace

ObjectPointer ObjectMaker::make(const Node& node, const ShapeModifiers& outer) {
    const ShapeModifiers modifiers = node.modifiers.within(outer);
    if (node.primitive) return makePrimitive(node, modifiers);
    return makeParts(node, modifiers);
}

bool ObjectMaker::withinBudget(const Node& node, const ShapeModifiers& modifiers) {
    gridPoints_ += gridPointsOf(*node.primitive, modifiers);
    if (gridPoints_ <= gridPointLimit) return true;
    context_.error("too-large", node.range,
                   "The surfaces of this text have more than " + std::to_string(gridPointLimit) +
                       " points; this one is left out.",
                   "give them fewer steps or subdivisions");
    return false;
}

ObjectPointer ObjectMaker::makePrimitive(const Node& node, const ShapeModifiers& modifiers) {
    std::vector<Drawn>& known = drawn_[&node];
    for (const Drawn& drawn : known)
        if (drawn.modifiers == modifiers) return drawn.object;
    if (!withinBudget(node, modifiers)) return nullptr;
    // What gridPointsOf() counts fits into memory, but not twice the time.
    DrawnPrimitive drawn = drawPrimitive(*node.primitive, modifiers, context_.parameterTable);
    ObjectPointer object;
    if (drawn.shape) {
        ObjectDescription description;
        description.keyword = node.keyword;
        description.range = node.range;
        description.shape = drawn.shape;
        description.transform = drawn.place.then(transformOf(node.transforms));
        if (const auto surface = std::dynamic_pointer_cast<const Isosurface>(drawn.shape)) {
            const int number = context_.isosurfaceCount++;
            description.isosurface =
                IsosurfaceStatement{surface, node.range, node.functionRange,
                                    std::string(context_.sources.slice(node.functionRange)), number};
        }
        object = std::make_shared<const ObjectDescription>(std::move(description));
    } else {
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
    for (ClippingObject& clip : copy.clips) clip.transform = clip.transform.then(transform);
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
            description.clips.push_back({parts[i], {}});
        else
            description.parts.push_back(parts[i]);
    }
    description.inverse = node.operation == SetOperation::inverse;
    if (node.modifiers.bound) {
        ObjectDescription room;
        room.keyword = "Bound";
        room.range = node.range;
        room.shape = std::make_shared<Box>((*node.modifiers.bound)[0], (*node.modifiers.bound)[1]);
        description.clips.push_back({std::make_shared<const ObjectDescription>(std::move(room)), {}});
    }
    return placed(node, std::make_shared<const ObjectDescription>(std::move(description)));
}

}  // namespace isoscope::virtualight
