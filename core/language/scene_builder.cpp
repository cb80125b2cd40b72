// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/scene_builder.h"

#include <algorithm>

#include "core/language/light_parser.h"
#include "core/shapes/bounded_shape.h"
#include "core/shapes/clipped_shape.h"
#include "core/shapes/inverse_shape.h"
#include "core/shapes/placed_shape.h"

namespace isoscope {

MaterialId SceneBuilder::addMaterial(const Material& material, const Transform& outer) {
    scene_.materials.push_back(moved(material, outer));
    return static_cast<MaterialId>(scene_.materials.size() - 1);
}

void SceneBuilder::add(const ObjectPointer& object, const Material& defaults) {
    if (defaultSource_ != &defaults) {
        defaultMaterial_ = addMaterial(defaults, {});
        defaultSource_ = &defaults;
    }
    Surroundings around;
    around.material = defaultMaterial_;
    add(*object, around, defaults);
}

bool SceneBuilder::staysTogether(const ObjectDescription& description) {
    if (description.parts.size() < manyParts) return false;
    const auto plain = [](const auto& self, const ObjectDescription& part) -> bool {
        return part.castsShadow && part.visible && part.reflected && part.lights.empty() &&
               !part.isosurface &&
               std::all_of(part.parts.begin(), part.parts.end(),
                           [&](const ObjectPointer& inner) { return self(self, *inner); });
    };
    return std::all_of(description.parts.begin(), description.parts.end(),
                       [&](const ObjectPointer& part) { return plain(plain, *part); });
}

void SceneBuilder::add(const ObjectDescription& description, const Surroundings& around,
                       const Material& defaults) {
    Surroundings inside = around;
    inside.transform = description.transform.then(around.transform);
    if (description.material) inside.material = addMaterial(*description.material, around.transform);
    inside.castsShadow &= description.castsShadow;
    inside.visible &= description.visible;
    inside.reflected &= description.reflected;
    inside.hollow |= description.hollow;
    inside.doubleIlluminate |= description.doubleIlluminate;
    for (const LightSource& light : description.lights)
        scene_.lights.push_back(transformed(light, around.transform));
    const bool isUnion = !description.shape && description.operation == CsgOperation::union_;
    if (isUnion && description.clips.empty() && !description.inverse && !staysTogether(description)) {
        // A ray that misses the bounds of the union misses all of its parts.
        for (ShapePointer& limit : shapes(description.limits, around.transform))
            inside.limits.push_back(std::move(limit));
        for (const ObjectPointer& part : description.parts) add(*part, inside, defaults);
        return;
    }
    if (!description.shape && description.parts.empty()) return;
    SceneObject object;
    object.shape = boundedBy(shape(description, around.transform), around.limits);
    object.material = inside.material;
    object.castsShadow = inside.castsShadow;
    object.visible = inside.visible;
    object.reflected = inside.reflected;
    object.hollow = inside.hollow;
    object.doubleIlluminate = inside.doubleIlluminate;
    object.name = description.keyword;
    object.range = description.range;
    scene_.objects.push_back(std::move(object));
}

void SceneBuilder::noteIsosurface(const IsosurfaceStatement& statement, const Transform& transform) {
    // Copies of a declared isosurface are one statement of the text.
    if (!noted_.insert(statement.shape.get()).second) return;
    scene_.isosurfaces.push_back({statement.shape, transform, statement.range, statement.functionRange,
                                  statement.functionText, statement.number});
}

ShapePointer SceneBuilder::bareShape(const ObjectDescription& description, const Transform& transform,
                                     MaterialId material) {
    if (description.isosurface) noteIsosurface(*description.isosurface, transform);
    if (description.shape) {
        if (transform.identity() && material == noMaterial) return description.shape;
        const ShapePointer aware = description.shape->awareOf(transform);
        return std::make_shared<PlacedShape>(aware ? aware : description.shape, transform, material);
    }
    std::vector<ShapePointer> parts;
    // `no_shadow` on a part counts for nothing here, as in POV-Ray: only members of a plain union are objects
    // of their own.
    for (const ObjectPointer& part : description.parts) parts.push_back(shape(*part, transform));
    ShapePointer joined = std::make_shared<Csg>(description.operation, std::move(parts));
    if (material == noMaterial) return joined;
    return std::make_shared<PlacedShape>(std::move(joined), Transform(), material);
}

ShapePointer SceneBuilder::shape(const ObjectDescription& description, const Transform& outer) {
    const Transform transform = description.transform.then(outer);
    const MaterialId material = description.material ? addMaterial(*description.material, outer) : noMaterial;
    ShapePointer result = bareShape(description, transform, material);
    if (description.inverse) result = inverseOf(result);
    if (!description.clips.empty())
        result = std::make_shared<ClippedShape>(std::move(result), shapes(description.clips, outer));
    return boundedBy(std::move(result), shapes(description.limits, outer));
}

std::vector<ShapePointer> SceneBuilder::shapes(const std::vector<ClippingObject>& objects,
                                               const Transform& outer) {
    std::vector<ShapePointer> result;
    for (const ClippingObject& object : objects)
        result.push_back(shape(*object.object, object.transform.then(outer)));
    return result;
}

}  // namespace isoscope
