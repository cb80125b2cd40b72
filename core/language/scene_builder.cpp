// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/scene_builder.h"

#include <algorithm>
#include <utility>

#include "core/language/light_parser.h"
#include "core/language/objects/shape_parser.h"
#include "core/shapes/combined/bounded_shape.h"
#include "core/shapes/combined/placed_shape.h"
#include "core/texture/cutaway_textures.h"
#include "core/texture/surface_needs.h"
#include "core/texture/transparency.h"
#include "core/texture/warped_material.h"

namespace isoscope {

MaterialId SceneBuilder::addMaterial(const Material& material, const Transform& outer, InteriorId interior) {
    scene_.materials.push_back(moved(material, outer));
    // In POV-Ray, textures of parts move with the whole, and are laid on the surface after that.
    if (onSurface_) scene_.materials.back() = laidOnSurface(warped(scene_.materials.back(), {}));
    scene_.materials.back().interior = interior;
    scene_.materials.back().lightGroup = lightGroup_;
    scene_.materials.back().doubleIlluminate = doubleIlluminate_;
    return static_cast<MaterialId>(scene_.materials.size() - 1);
}

InteriorId SceneBuilder::addInterior(const Interior& interior, const Transform& outer, bool hollow) {
    scene_.interiors.push_back(moved(interior, outer));
    scene_.interiors.back().hollow = hollow;
    scene_.interiors.back().lightGroup = lightGroup_;
    return static_cast<InteriorId>(scene_.interiors.size() - 1);
}

MaterialId SceneBuilder::withInterior(MaterialId material, InteriorId interior) {
    if (material == noMaterial || interior == noInterior) return material;
    const Material& before = scene_.materials[static_cast<std::size_t>(material)];
    if (before.interior == interior) return material;
    const auto [found, isNew] = withInteriors_.try_emplace({material, interior}, material);
    if (isNew) found->second = addMaterial(Material(before), {}, interior);
    return found->second;
}

template <class Test>
bool SceneBuilder::anyMaterial(const ObjectDescription& description, const Material& inherited, Test test) {
    const Material& own = description.material ? *description.material : inherited;
    if (description.interiorTexture && test(*description.interiorTexture)) return true;
    if (description.partTextures &&
        std::any_of(description.partTextures->begin(), description.partTextures->end(), test))
        return true;
    if (description.parts.empty()) return test(own);
    return std::any_of(description.parts.begin(), description.parts.end(),
                       [&](const ObjectPointer& part) { return anyMaterial(*part, own, test); });
}

void SceneBuilder::add(const ObjectPointer& object, const Material& defaults) {
    if (defaultSource_ != &defaults) {
        defaultMaterial_ = addMaterial(defaults, {}, noInterior);
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
               !part.isosurface && !part.doubleIlluminate && !part.cutawayTextures &&
               std::all_of(part.parts.begin(), part.parts.end(),
                           [&](const ObjectPointer& inner) { return self(self, *inner); });
    };
    return std::all_of(description.parts.begin(), description.parts.end(),
                       [&](const ObjectPointer& part) { return plain(plain, *part); });
}

MaterialId SceneBuilder::again(MaterialId material) {
    const Material before = scene_.materials[static_cast<std::size_t>(material)];
    return addMaterial(before, {}, before.interior);
}

void SceneBuilder::add(const ObjectDescription& description, const Surroundings& around,
                       const Material& defaults) {
    const bool opensGroup = description.keyword == "light_group";
    const bool turnsDouble = description.doubleIlluminate && !doubleIlluminate_;
    if (!opensGroup && !turnsDouble) return addInside(description, around, defaults);
    const int group = lightGroup_;
    const bool both = doubleIlluminate_;
    if (opensGroup) {
        // What a group says of global lights holds for the groups in it as well.
        const bool outer = group > 0 && scene_.lightGroups[static_cast<std::size_t>(group)].globalLights;
        lightGroup_ = static_cast<int>(scene_.lightGroups.size());
        scene_.lightGroups.push_back({description.globalLights || outer});
    }
    doubleIlluminate_ |= turnsDouble;
    Surroundings own = around;
    own.material = again(around.material);
    addInside(description, own, defaults);
    lightGroup_ = group;
    doubleIlluminate_ = both;
}

Material SceneBuilder::ownMaterial(const ObjectDescription& description, const Material& inherited) {
    Material own = description.material ? *description.material : inherited;
    return description.interiorTexture ? twoSided(std::move(own), *description.interiorTexture) : own;
}

MaterialId SceneBuilder::onShape(MaterialId material, const ObjectDescription& description,
                                 const Transform& transform) {
    if (material == noMaterial) return noMaterial;
    if (!description.partTextures && !onSurface(scene_.materials[static_cast<std::size_t>(material)]))
        return material;
    const Material base = scene_.materials[static_cast<std::size_t>(material)];
    Material own = base;
    own.surface = std::make_shared<const TexturedShape>(TexturedShape{description.shape, transform});
    if (description.partTextures) {
        auto parts = std::make_shared<MappedTexture>();
        parts->kind = MapKind::surface;
        parts->entries.push_back({0, base});
        for (const Material& texture : *description.partTextures)
            parts->entries.push_back({0, moved(texture, transform)});
        own.map = std::move(parts);
        own.below.clear();
        own.mapTransform = Transform();
    }
    return addMaterial(own, {}, base.interior);
}

void SceneBuilder::addInside(const ObjectDescription& description, const Surroundings& around,
                             const Material& defaults) {
    Surroundings inside = around;
    inside.transform = description.transform.then(around.transform);
    inside.hollow |= description.hollow;
    if (description.interior)
        inside.interior = addInterior(*description.interior, around.transform, inside.hollow);
    if (description.material)
        inside.material = addMaterial(ownMaterial(description, defaults), around.transform, inside.interior);
    else if (description.interiorTexture)
        inside.material = addMaterial(twoSided(scene_.materials[static_cast<std::size_t>(around.material)],
                                               moved(*description.interiorTexture, around.transform)),
                                      {}, inside.interior);
    inside.textured |= description.material.has_value();
    inside.castsShadow &= description.castsShadow;
    inside.visible &= description.visible;
    inside.reflected &= description.reflected;
    inside.doubleIlluminate |= description.doubleIlluminate;
    for (const LightSource& light : description.lights) {
        scene_.lights.push_back(transformed(light, around.transform));
        scene_.lights.back().group = lightGroup_;
    }
    const bool isUnion = !description.shape && description.operation == CsgOperation::union_;
    const auto fallsApart = [](const Wrapping& wrapping) {
        return !wrapping.on || wrapping.modifier->limitsRays;
    };
    if (isUnion && std::ranges::all_of(description.wrappings, fallsApart) && !staysTogether(description)) {
        // A ray that misses the bounds of the union misses all of its parts.
        for (const Wrapping& wrapping : description.wrappings)
            for (ShapePointer& limit : shapes(wrapping.objects, around.transform))
                inside.limits.push_back(std::move(limit));
        // Of equal hits the first object shows; POV-Ray keeps a union together that has bounds, and of its
        // parts the last shows.
        const bool outer = std::exchange(onSurface_, onSurface_ || description.partsOnSurface);
        if (inside.limits.empty())
            for (const ObjectPointer& part : description.parts) add(*part, inside, defaults);
        else
            for (std::size_t k = description.parts.size(); k-- > 0;)
                add(*description.parts[k], inside, defaults);
        onSurface_ = outer;
        return;
    }
    if (description.shape || !description.parts.empty()) addObject(description, around, inside);
}

bool SceneBuilder::bendsLight(const ObjectDescription& description) {
    return (description.interior && description.interior->ior != 1) ||
           std::any_of(description.parts.begin(), description.parts.end(),
                       [](const ObjectPointer& part) { return bendsLight(*part); });
}

namespace {

bool limitsRays(const Wrapping& wrapping) { return wrapping.on && wrapping.modifier->limitsRays; }

bool ignoresBounds(const ObjectDescription& description) {
    if (!description.shape || std::ranges::none_of(description.wrappings, limitsRays)) return false;
    const ShapeParser* parser = findShapeParser(description.keyword);
    return parser && parser->ignoresOwnBounds;
}

ObjectDescription withoutBounds(ObjectDescription description) {
    std::erase_if(description.wrappings, limitsRays);
    return description;
}

}  // namespace

void SceneBuilder::addObject(const ObjectDescription& description, const Surroundings& around,
                             const Surroundings& inside) {
    SceneObject object;
    const Material& seen = scene_.materials[static_cast<std::size_t>(inside.material)];
    object.transparent =
        anyMaterial(description, seen, [](const Material& material) { return mayLetLightThrough(material); });
    object.reflective =
        anyMaterial(description, seen, [](const Material& material) { return mayReflect(material); });
    object.interior = inside.interior;
    // Rays that go through it know it by its inside; and fog ends at what is not hollow.
    if (object.interior == noInterior && (object.transparent || (!scene_.fogs.empty() && !inside.hollow)))
        object.interior = addInterior({}, {}, inside.hollow);
    Inherited from{inside.material, object.interior};
    if (description.cutawayTextures && !inside.textured)
        from.material = addCutaway(description, around.transform, inside.material);
    if (object.transparent || inside.interior != noInterior)
        from.material = withInterior(from.material, object.interior);
    cutaway_ = description.cutawayTextures && !inside.textured ? from.material : noMaterial;
    plain_ = inside.material;
    object.bendsLight =
        bendsLight(description) || (object.interior != noInterior &&
                                    scene_.interiors[static_cast<std::size_t>(object.interior)].ior != 1);
    object.shape = boundedBy(ignoresBounds(description)
                                 ? shape(withoutBounds(description), around.transform, from, noMaterial)
                                 : shape(description, around.transform, from, noMaterial),
                             around.limits);
    object.material = from.material;
    object.castsShadow = inside.castsShadow;
    object.visible = inside.visible;
    object.reflected = inside.reflected;
    object.hollow = inside.hollow;
    object.doubleIlluminate = inside.doubleIlluminate;
    object.name = description.keyword;
    object.range = description.range;
    object.line = description.line;
    scene_.objects.push_back(std::move(object));
}

void SceneBuilder::noteIsosurface(const IsosurfaceStatement& statement, const Transform& transform) {
    // Copies of a declared isosurface are one statement of the text.
    if (!noted_.insert(statement.shape.get()).second) return;
    scene_.isosurfaces.push_back({statement.shape, transform, statement.range, statement.functionRange,
                                  statement.functionText, statement.written, statement.containerRange,
                                  statement.number});
}

ShapePointer SceneBuilder::bareShape(const ObjectDescription& description, const Transform& transform,
                                     MaterialId material, const Inherited& from) {
    if (description.isosurface) noteIsosurface(*description.isosurface, transform);
    if (description.shape) {
        const MaterialId seen = material == noMaterial ? from.material : material;
        const MaterialId own = seen == cutaway_ ? seen : onShape(seen, description, transform);
        if (own != seen) material = own;
        if (transform.identity() && material == noMaterial) return description.shape;
        const ShapePointer aware = description.shape->awareOf(transform);
        return std::make_shared<PlacedShape>(aware ? aware : description.shape, transform, material);
    }
    std::vector<ShapePointer> parts;
    // `no_shadow` on a part counts for nothing here, as in POV-Ray: only members of a plain union are objects
    // of their own.
    const bool outer = std::exchange(onSurface_, onSurface_ || description.partsOnSurface);
    for (const ObjectPointer& part : description.parts) parts.push_back(partShape(*part, transform, from));
    onSurface_ = outer;
    ShapePointer joined = std::make_shared<Csg>(description.operation, std::move(parts));
    if (material == noMaterial) return joined;
    return std::make_shared<PlacedShape>(std::move(joined), Transform(), material);
}

ShapePointer SceneBuilder::partShape(const ObjectDescription& part, const Transform& outer,
                                     const Inherited& from) {
    const bool cuts = !part.parts.empty() && (part.operation == CsgOperation::intersection ||
                                              part.operation == CsgOperation::difference);
    if (!cuts || from.material == noMaterial || from.material != cutaway_) return shape(part, outer, from);
    const Inherited own = inherited(part, outer, {withInterior(plain_, from.interior), from.interior});
    return shape(part, outer, own, own.material);
}

namespace {

/// The parts of a solid, and the textures of those that have some, in world coordinates.
class CutawayReader {
  public:
    CutawayReader(MappedTexture& textures, std::shared_ptr<const std::vector<double>> parameters)
        : textures_(textures), parameters_(std::move(parameters)) {}

    std::vector<CutawayTextures::Part> partsOf(const ObjectDescription& description, const Transform& outer) {
        const Transform transform = description.transform.then(outer);
        const bool subtracts = description.operation == CsgOperation::difference;
        std::vector<CutawayTextures::Part> parts;
        for (std::size_t k = 0; k < (subtracts ? 1 : description.parts.size()); ++k)
            parts.push_back(partOf(*description.parts[k], transform));
        return parts;
    }

  private:
    CutawayTextures::Part partOf(const ObjectDescription& description, const Transform& outer) {
        CutawayTextures::Part part;
        Scene scratch;
        part.solid =
            std::make_shared<const ObjectTable>(SceneBuilder(scratch).shape(description, outer), parameters_);
        part.joins =
            description.operation == CsgOperation::union_ || description.operation == CsgOperation::merge;
        if (description.material) {
            part.texture = textures_.entries.size();
            textures_.entries.push_back({0, moved(*description.material, outer)});
        } else if (!description.parts.empty()) {
            part.parts = partsOf(description, outer);
        }
        return part;
    }

    MappedTexture& textures_;
    std::shared_ptr<const std::vector<double>> parameters_;
};

}  // namespace

MaterialId SceneBuilder::addCutaway(const ObjectDescription& description, const Transform& outer,
                                    MaterialId plain) {
    const Material base = scene_.materials[static_cast<std::size_t>(plain)];
    auto textures = std::make_shared<MappedTexture>();
    textures->kind = MapKind::surface;
    textures->entries.push_back({0, base});
    CutawayTextures::Part whole;
    whole.parts = CutawayReader(*textures, scene_.parameterTable).partsOf(description, outer);
    Material material = base;
    material.surface = std::make_shared<const TexturedShape>(
        TexturedShape{std::make_shared<const CutawayTextures>(std::move(whole)), Transform()});
    material.map = std::move(textures);
    material.below.clear();
    return addMaterial(material, {}, base.interior);
}

SceneBuilder::Inherited SceneBuilder::inherited(const ObjectDescription& description, const Transform& outer,
                                                const Inherited& from) {
    Inherited own = from;
    if (description.interior) own.interior = addInterior(*description.interior, outer, description.hollow);
    if (description.material)
        own.material = addMaterial(ownMaterial(description, {}), outer, own.interior);
    else if (description.interiorTexture && from.material != noMaterial)
        own.material = addMaterial(twoSided(scene_.materials[static_cast<std::size_t>(from.material)],
                                            moved(*description.interiorTexture, outer)),
                                   {}, own.interior);
    else if (description.interior)
        own.material = withInterior(from.material, own.interior);
    return own;
}

ShapePointer SceneBuilder::shape(const ObjectDescription& description, const Transform& outer) {
    return shape(description, outer, Inherited());
}

ShapePointer SceneBuilder::shape(const ObjectDescription& description, const Transform& outer,
                                 const Inherited& from) {
    const Inherited own = inherited(description, outer, from);
    return shape(description, outer, own, own.material == from.material ? noMaterial : own.material);
}

ShapePointer SceneBuilder::shape(const ObjectDescription& description, const Transform& outer,
                                 const Inherited& own, MaterialId material) {
    const Transform transform = description.transform.then(outer);
    ShapePointer result = bareShape(description, transform, material, own);
    for (const Wrapping& wrapping : description.wrappings)
        if (wrapping.on)
            result = wrapping.modifier->wrap(std::move(result), wrapping, shapes(wrapping.objects, outer));
    return result;
}

std::vector<ShapePointer> SceneBuilder::shapes(const std::vector<ClippingObject>& objects,
                                               const Transform& outer) {
    std::vector<ShapePointer> result;
    for (const ClippingObject& object : objects)
        result.push_back(shape(*object.object, object.transform.then(outer)));
    return result;
}

}  // namespace isoscope
