// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
    /// The shape alone.
    ShapePointer shape(const ObjectDescription& description, const Transform& outer = {});

    static constexpr std::size_t manyParts = 32;

  private:
    struct Surroundings {
        Transform transform;
        MaterialId material = noMaterial;
        bool castsShadow = true;
        bool visible = true;
        bool reflected = true;
        bool hollow = false;
        bool doubleIlluminate = false;
        std::vector<ShapePointer> limits;  ///< of `bounded_by` around it, in world coordinates
    };

    void add(const ObjectDescription& description, const Surroundings& around, const Material& defaults);
    /// Whether a union has many parts and none of them must be an object of its own: for a flag, a light or
    /// an isosurface, which are searched for many rays at a time.
    static bool staysTogether(const ObjectDescription& description);
    MaterialId addMaterial(const Material& material, const Transform& outer);
    ShapePointer bareShape(const ObjectDescription& description, const Transform& transform,
                           MaterialId material);
    std::vector<ShapePointer> shapes(const std::vector<ClippingObject>& objects, const Transform& outer);
    void noteIsosurface(const IsosurfaceStatement& statement, const Transform& transform);

    Scene& scene_;
    std::set<const Isosurface*> noted_;
    MaterialId defaultMaterial_ = noMaterial;
    const Material* defaultSource_ = nullptr;
};

}  // namespace isoscope
