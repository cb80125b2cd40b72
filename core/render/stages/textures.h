// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/stages/stage.h"
#include "core/scene/scene.h"

namespace isoscope {

class TextureWork;

/// Looks up what textures say about the batch's points: colours of pigments and normals that differ from
/// place to place, all points of one pattern together. Where a texture has layers or a map, a point becomes
/// several, one for each part that shows, and SurfacePoints::weight says how much of it. Points of other
/// materials cost nothing.
class Textures : public Stage {
  public:
    /// The scene must outlive the stage. Where `transparency` is not shown, the lowest layer is opaque.
    Textures(const Scene& scene, bool transparency);

    void run(TileScratch& work, SampleBatch& batch) const override;
    /// The same for points of no batch; layers that conserve energy let through what they would without.
    void lookUp(SurfacePoints& points, TileScratch& work) const { lookUp(points, nullptr, work); }

  private:
    /// The material, or null where there is none.
    const Material* materialOf(MaterialId id) const;
    void lookUp(SurfacePoints& points, const SampleBatch* batch, TileScratch& work) const;
    // These return how many values they have looked up.
    std::size_t separateParts(SurfacePoints& points, TextureWork& own) const;
    std::size_t bendNormals(SurfacePoints& points, TextureWork& own) const;
    std::size_t findPigments(SurfacePoints& points, TextureWork& own) const;
    /// Takes the outermost maps and layers apart, maps at their values; false when there was none.
    bool takeApart(const SurfacePoints& points, TextureWork& own) const;
    /// Whether what lies below, of which so much is seen, counts.
    bool isSeen(const glm::dvec3& through) const;
    void weighParts(SurfacePoints& points, const SampleBatch* batch, TextureWork& own) const;
    /// What reflection leaves of the light that comes through point k.
    glm::dvec3 conserved(const SurfacePoints& points, std::size_t k, const SampleBatch& batch) const;

    const Scene& scene_;
    bool hasParts_ = false;
    bool hasNormals_ = false;
    bool tints_ = false;  ///< mirrors or highlights ask for the pigments
    bool transparency_;
};

}  // namespace isoscope
