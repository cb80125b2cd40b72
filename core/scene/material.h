// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/evaluate/tape/tape.h"
#include "core/scene/color.h"
#include "core/scene/interior.h"
#include "core/scene/pigment.h"
#include "core/shapes/hit.h"
#include "core/shapes/shape.h"
#include "core/shapes/transform.h"

namespace isoscope {

/// How a surface answers light, with POV-Ray 3.7's defaults. Colours are factors per channel.
struct Finish {
    Color ambient{0.1, 0.1, 0.1};
    Color emission{};
    double diffuse = 0.6;
    double diffuseBack = 0;
    double brilliance = 1;
    double phong = 0;
    double phongSize = 40;
    double specular = 0;
    double roughness = 0.05;
    bool diffuseAlbedo = false, phongAlbedo = false, specularAlbedo = false;  ///< see plainFinish()
    double metallic = 0;
    double crand = 0;
    Color reflectionMinimum{};  ///< of light that falls in straight
    Color reflectionMaximum{};  ///< of grazing light
    double reflectionFalloff = 1;
    bool reflectionFresnel = false;  ///< by the interior's ior, in place of the falloff
    double reflectionExponent = 1;   ///< reflected light counts to the power of 1 / this
    double reflectionMetallic = 0;
    bool conserveEnergy = false;
    double irid = 0;  ///< how much a thin film adds to or takes from light
    double iridThickness = 0;
    double iridTurbulence = 0;  ///< how much the thickness differs from place to place
    /// Keywords of the scene that have no effect here ("subsurface"), for the list of what was left out.
    std::vector<std::string> notSimulated;

    /// Of the cosine of `specular`; POV-Ray takes 0 where `roughness` is 0.
    double specularExponent() const { return roughness != 0 ? 1 / roughness : 0; }
    /// Whether it mirrors some light at some angle.
    bool reflects() const {
        const auto some = [](const Color& c) { return c.red != 0 || c.green != 0 || c.blue != 0; };
        return some(reflectionMinimum) || some(reflectionMaximum);
    }
};

/// The finish without `albedo`, which gives what a surface returns of all light in all, that returns as much;
/// where `diffuse` is negative, it returns nothing by that (POV-Ray 3.7, measured).
Finish plainFinish(Finish finish);

struct SurfaceNormal;
struct MappedTexture;

/// The single shape that a material is on, for what its textures ask of it.
struct TexturedShape {
    ShapePointer shape;
    Transform transform;  ///< from its coordinates to the world's
};

/// One texture: what a shape looks like where a ray meets it.
struct Material {
    Pigment pigment = SolidPigment{};
    bool pigmentStated = false;  ///< the text gives one; POV-Ray's default is black
    /// What has moved the pigment since it was written, from its own coordinates to the object's, or to the
    /// world's in Scene::materials.
    Transform pigmentTransform;
    std::shared_ptr<const SurfaceNormal> normal;  ///< null: the shape's own
    Transform normalTransform;                    ///< as pigmentTransform
    Finish finish;
    std::vector<std::string> notSimulated;  ///< as in Finish: "projection"

    /// The textures that lie under this one, from the outside in; they show where it is transparent.
    std::vector<Material> below;
    /// A pattern of textures, which stands in place of all the above.
    std::shared_ptr<const MappedTexture> map;
    Transform mapTransform;  ///< as pigmentTransform

    /// Of `material { }`: what it says about the inside; null when it says nothing.
    std::shared_ptr<const Interior> inside;

    // Of Scene::materials only:
    InteriorId interior = noInterior;  ///< behind this surface
    /// Where something in it is looked up at the place on the surface, or chosen by it; null otherwise.
    std::shared_ptr<const TexturedShape> surface;
    int lightGroup = 0;             ///< index into Scene::lightGroups
    bool doubleIlluminate = false;  ///< lights of the other side count as well
    bool transparent = false;       ///< some light may come through; made by compileMaterials()

    // Of Scene::materials only, made by compileMaterials():
    /// The colour of the pigment at a point of its own coordinates, in red, green, blue, filter and transmit;
    /// null when it is the same everywhere.
    std::shared_ptr<const Tape> pigmentTape;
    /// Where this is set, the tape gives the place in the image instead of the colour.
    std::shared_ptr<const ImageMap> image;
    /// The normal at a point, in arguments 0 to 2, where the shape's is arguments 3 to 5.
    std::shared_ptr<const Tape> normalTape;
    /// How thick the film of the finish is at a point of the world; null when it is the same everywhere.
    std::shared_ptr<const Tape> filmTape;
    /// The value of the pattern of `map`.
    std::shared_ptr<const Tape> mapTape;
    /// Of `map` its entries, else this one without the layers below, and those; empty for a single texture.
    std::vector<MaterialId> parts;

    /// Whether it differs from place to place, or is made of several.
    bool patterned() const { return pigmentTape || normalTape || !parts.empty(); }
};

/// A pattern that chooses among textures (MappedPigment).
struct MappedTexture {
    /// One texture of the map and its place: a value of the pattern, or a weight (MapKind).
    struct Entry {
        double position = 0;
        Material material;
    };

    Pattern pattern;
    MapKind kind = MapKind::blend;
    std::vector<Entry> entries;  ///< at least one
    bool onSurface = false;      ///< as MappedPigment::onSurface

    /// As MappedPigment::size and MappedPigment::depth, of textures.
    std::size_t size = 1;
    int depth = 1;
};

/// Textures in a material, layers and entries of maps counted; and the height of their tree.
std::size_t sizeOf(const Material& material);
int depthOf(const Material& material);
/// How many of its textures may show at one point; a point takes memory for each of them, so that parsers
/// limit it.
std::size_t shownAtOnce(const Material& material);
constexpr std::size_t shownAtOnceLimit = 200;

/// `top` with `under` below it, and below what is below `top` already.
Material laidOver(Material top, Material under);

/// A material that looks different from the inside of its object.
Material twoSided(Material outside, Material inside);

/// The material of an object that has been moved.
Material moved(Material material, const Transform& transform);

}  // namespace isoscope
