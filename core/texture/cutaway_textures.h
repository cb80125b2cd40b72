// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/shapes/shape.h"
#include "core/texture/tables/object_table.h"

namespace isoscope {

/// `cutaway_textures`: which textures a solid made of textured parts has at a point inside of it. Only
/// textureShares() says anything; a ray meets nothing here, and nothing is inside.
///
/// Measured on POV-Ray 3.7's pictures: all parts that hold the point show alike, those of unions, merges and
/// intersections that are parts themselves too, but not what a difference cuts away; a part without a texture
/// counts as one, as the default texture, in a union or merge only.
class CutawayTextures : public Shape {
  public:
    /// A solid within the whole.
    struct Part {
        /// Whether points lie in it; null for what a difference cuts away.
        std::shared_ptr<const ObjectTable> solid;
        std::size_t texture = 0;  ///< as Shape::textureShares; 0: none of its own
        bool joins = false;       ///< a union or merge of its parts
        std::vector<Part> parts;
    };

    explicit CutawayTextures(Part whole) : whole_(std::move(whole)) {}

    std::vector<TextureShare> textureShares(const glm::dvec3& point) const override;

    void intersect(const Ray&, RayInterval, TraceContext&, HitList&) const override {}
    bool contains(const glm::dvec3&, TraceContext&) const override { return false; }
    Bounds bounds() const override { return {glm::dvec3(0), glm::dvec3(0)}; }

  private:
    Part whole_;
};

}  // namespace isoscope
