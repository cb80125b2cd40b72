// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/render/stages/stage.h"

namespace isoscope {

/// Several light filters as one, each weakening what those before have left.
class FilterChain : public LightFilter {
  public:
    explicit FilterChain(std::vector<std::unique_ptr<LightFilter>> filters) : filters_(std::move(filters)) {}

    void filter(TileScratch& work, SurfacePoints& points, std::size_t light) const override {
        for (const auto& each : filters_) each->filter(work, points, light);
    }

  private:
    std::vector<std::unique_ptr<LightFilter>> filters_;
};

}  // namespace isoscope
