// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/stages/stage.h"
#include "core/scene/scene.h"

namespace isoscope {

/// `crand`: surfaces that return less of each light at random, as if they were grainy. POV-Ray takes up to
/// `crand` off the diffuse part, the same of all channels (measured on its pictures). Here the grain depends
/// on the place alone, so that a picture is the same each time. Stands before the shadows. Sends no rays.
class Grain : public LightFilter {
  public:
    /// The scene must outlive the stage.
    explicit Grain(const Scene& scene) : scene_(scene) {}

    void filter(TileScratch& work, SurfacePoints& points, std::size_t light) const override;

  private:
    const Scene& scene_;
};

}  // namespace isoscope
