// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/progressive/tile_scratch.h"

namespace isoscope {

/// One effect of the picture. Built only when the plan holds it, shared by all threads; all that changes is
/// in the TileScratch. A stage counts its rays and, at its end, charges what it has spent
/// (TileScratch::charge).
class Stage {
  public:
    virtual ~Stage() = default;

    /// Carries the samples of `batch`, one of those of `work`, one step further.
    virtual void run(TileScratch& work, SampleBatch& batch) const = 0;
};

/// A stage that stands between a light and the surface: it weakens SurfacePoints::returned of `points`, where
/// it also finds how the light arrives.
class LightFilter {
  public:
    virtual ~LightFilter() = default;

    /// For light number `light` of the scene.
    virtual void filter(TileScratch& work, SurfacePoints& points, std::size_t light) const = 0;
};

}  // namespace isoscope
