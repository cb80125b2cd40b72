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
    /// The scene must outlive the stage.
    explicit Textures(const Scene& scene);

    void run(TileWork& work, SampleBatch& batch) const override;

  private:
    /// The material, or null where there is none.
    const Material* materialOf(MaterialId id) const;
    // These return how many values they have looked up.
    std::size_t separateParts(SurfacePoints& points, TextureWork& own) const;
    std::size_t bendNormals(SurfacePoints& points, TextureWork& own) const;
    std::size_t findPigments(SurfacePoints& points, TextureWork& own) const;
    /// Takes the outermost maps and layers apart, maps at their values; false when there was none.
    bool takeApart(const std::vector<double>& values, TextureWork& own) const;
    void weighParts(SurfacePoints& points, TextureWork& own) const;

    const Scene& scene_;
    bool hasParts_ = false;
    bool hasNormals_ = false;
};

}  // namespace isoscope
