// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/function/written_work.h"
#include "core/language/objects/wrapping_modifier.h"
#include "core/scene/light_source.h"
#include "core/scene/material.h"
#include "core/shapes/combined/csg.h"
#include "core/shapes/isosurface/isosurface.h"
#include "core/shapes/transform.h"
#include "core/text/source_text.h"

namespace isoscope {

/// An isosurface statement: its shape, shared by all copies of the object, and its place in the text.
struct IsosurfaceStatement {
    std::shared_ptr<const Isosurface> shape;
    SourceRange range;
    SourceRange functionRange;
    std::string functionText;
    std::shared_ptr<const WrittenWork> written;
    SourceRange containerRange;  ///< between the braces of `contained_by { }`; empty where there is none
    int number =
        0;  ///< of isosurface statements in the order of reading; those of loops and macros count each time
};

/// An object statement as it was read: what `#declare Name = sphere { ... }` keeps, and what SceneBuilder
/// makes shapes of. Immutable once read; `object { Name ... }` copies it and goes on.
struct ObjectDescription {
    std::string keyword;  ///< "sphere", "union", ...
    SourceRange range;
    int line = 0;  ///< where it begins

    // One of: a shape in its own coordinates; an isosurface; parts joined by `operation`.
    ShapePointer shape;
    std::optional<IsosurfaceStatement> isosurface;
    CsgOperation operation = CsgOperation::union_;
    std::vector<ObjectPointer> parts;
    std::vector<LightSource> lights;  ///< in unions, moved by the transforms of the union as they come

    Transform transform;
    std::optional<Material> material;
    std::shared_ptr<const Interior> interior;
    bool hasTexture = false;  ///< `material` was given by `texture`, not put together from pigment and finish
    std::optional<Material> interiorTexture;
    /// Of parts of the shape, in its own coordinates; null where it has none.
    std::shared_ptr<const std::vector<Material>> partTextures;
    /// `uv_mapping`: textures of parts are looked up at places on their surfaces, too.
    bool partsOnSurface = false;
    bool globalLights = false;  ///< of `light_group`: lights of no group reach its objects
    /// One for each modifier that has been said, in the order in which they go around the shape.
    std::vector<Wrapping> wrappings;
    bool castsShadow = true;
    bool visible = true;
    bool reflected = true;
    bool hollow = false;            ///< media and fog fill it
    bool doubleIlluminate = false;  ///< light comes through from the other side
    /// `cutaway_textures`, of intersections and differences: what has no texture shows those of its inside.
    bool cutawayTextures = false;

    /// Shapes in it, and the height of its tree: both are limited, because declared objects may double with
    /// each line.
    std::size_t shapeCount = 1;
    int depth = 1;

    /// What is said of the modifier with this keyword; null: nothing.
    const Wrapping* wrapping(std::string_view keyword) const;
    /// The same, to say more of it.
    Wrapping& wrapping(const WrappingModifier& modifier);

    static constexpr std::size_t shapeLimit = 200'000;
    static constexpr int depthLimit = 100;
};

}  // namespace isoscope
