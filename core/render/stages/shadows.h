// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/light/object_tracer.h"
#include "core/render/stages/stage.h"

namespace isoscope {

/// Takes away the light that another object, or the same one, keeps from a surface. Transparent objects
/// are left to ClearShadows. One ray for each sample that the light would brighten.
class Shadows : public LightFilter {
  public:
    /// The scene must outlive the stage.
    explicit Shadows(const Scene& scene);

    void filter(TileScratch& work, SurfacePoints& points, std::size_t light) const override;

  private:
    const Scene& scene_;
    ObjectTracer occluders_;
};

}  // namespace isoscope
