// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>

#include "core/language/scene_draft.h"

namespace isoscope {

/// Makes shapes of object descriptions, in world coordinates: transforms go down to the parts, as in POV-Ray,
/// and each part keeps its own material.
class SceneBuilder {
  public:
    /// Materials and isosurfaces are added to `scene`.
    explicit SceneBuilder(Scene& scene) : scene_(scene) {}

    /// Adds an object; a union becomes one object for each of its parts, unless it has so many that the tree
    /// in Csg does better. `defaults` is the material of what has none.
    void add(const ObjectPointer& object, const Material& defaults);
    /// The shape alone, of what has no material of its own.
    ShapePointer shape(const ObjectDescription& description, const Transform& outer = {});

    static constexpr std::size_t manyParts = 32;

  private:
    struct Surroundings {
        Transform transform;
        MaterialId material = noMaterial;
        InteriorId interior = noInterior;
        bool castsShadow = true;
        bool visible = true;
        bool reflected = true;
        bool hollow = false;
        bool doubleIlluminate = false;
        bool textured = false;             ///< something around it has a texture
        std::vector<ShapePointer> limits;  ///< of `bounded_by` around it, in world coordinates
    };

    void add(const ObjectDescription& description, const Surroundings& around, const Material& defaults);
    /// Whether a union has many parts and none of them must be an object of its own: for a flag, a light or
    /// an isosurface, which are searched for many rays at a time.
    static bool staysTogether(const ObjectDescription& description);
    /// What the parts of an object have that say nothing else.
    struct Inherited {
        MaterialId material = noMaterial;
        InteriorId interior = noInterior;
    };
    /// The same material in the light group at hand and with `double_illuminate` as it stands.
    MaterialId again(MaterialId material);
    void addInside(const ObjectDescription& description, const Surroundings& around,
                   const Material& defaults);
    /// The description's own material, that of its inside included, in the place of `material`.
    static Material ownMaterial(const ObjectDescription& description, const Material& inherited);
    /// The material as the shape of the description has it, where it depends on that.
    MaterialId onShape(MaterialId material, const ObjectDescription& description, const Transform& transform);
    MaterialId addMaterial(const Material& material, const Transform& outer, InteriorId interior);
    InteriorId addInterior(const Interior& interior, const Transform& outer, bool hollow);
    /// The material with this inside.
    MaterialId withInterior(MaterialId material, InteriorId interior);
    /// What the description passes on to its parts.
    Inherited inherited(const ObjectDescription& description, const Transform& outer, const Inherited& from);
    /// Whether `test` is true of a material in it, `inherited` among them where it shows.
    template <class Test>
    static bool anyMaterial(const ObjectDescription& description, const Material& inherited, Test test);
    /// Whether an interior in it has an ior.
    static bool bendsLight(const ObjectDescription& description);
    ShapePointer shape(const ObjectDescription& description, const Transform& outer, const Inherited& from);
    /// Where `own` is known already, and `material` is for its hits.
    ShapePointer shape(const ObjectDescription& description, const Transform& outer, const Inherited& own,
                       MaterialId material);
    ShapePointer bareShape(const ObjectDescription& description, const Transform& transform,
                           MaterialId material, const Inherited& from);
    /// Of what goes around an object and shows no surface of its own.
    std::vector<ShapePointer> shapes(const std::vector<ClippingObject>& objects, const Transform& outer);
    /// The material of what has no texture in the object where it has `cutaway_textures`.
    MaterialId addCutaway(const ObjectDescription& description, const Transform& outer, MaterialId plain);
    /// A part of a solid: in those within a cutaway one, what has no texture has the default one.
    ShapePointer partShape(const ObjectDescription& part, const Transform& outer, const Inherited& from);
    void addObject(const ObjectDescription& description, const Surroundings& around,
                   const Surroundings& inside);
    void noteIsosurface(const IsosurfaceStatement& statement, const Transform& transform);

    Scene& scene_;
    std::set<const Isosurface*> noted_;
    std::map<std::pair<MaterialId, InteriorId>, MaterialId> withInteriors_;
    MaterialId defaultMaterial_ = noMaterial;
    const Material* defaultSource_ = nullptr;
    int lightGroup_ = 0;  ///< of the objects that are being added
    bool doubleIlluminate_ = false;
    bool onSurface_ = false;  ///< the parts that are being added are those of an object with `uv_mapping`
    /// Of the object at hand: the material by addCutaway(), and what it stands in for.
    MaterialId cutaway_ = noMaterial;
    MaterialId plain_ = noMaterial;
};

}  // namespace isoscope
