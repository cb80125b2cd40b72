// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/render/stages/stage.h"
#include "core/scene/scene.h"

namespace isoscope {

/// What surfaces shine by themselves (ambient, emission) and what they return of the light that falls on them
/// straight from a light source. Filters, if any, are asked about each light in turn. Sends no rays itself.
class DirectLight : public Stage {
  public:
    /// The scene and the filters must outlive the stage.
    DirectLight(const Scene& scene, std::vector<const LightFilter*> filters);

    void run(TileWork& work) const override;

  private:
    const Material& material(const Hit& hit) const;
    void ownLight(TileWork& work) const;
    void gather(TileWork& work, const LightSource& light) const;
    void add(TileWork& work) const;

    const Scene& scene_;
    std::vector<const LightFilter*> filters_;
    Material plain_;
};

}  // namespace isoscope
