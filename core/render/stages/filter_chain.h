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
    /// Appends a filter.
    void add(std::unique_ptr<LightFilter> filter) { filters_.push_back(std::move(filter)); }
    /// The same, but in front of all others.
    void addFirst(std::unique_ptr<LightFilter> filter) {
        filters_.insert(filters_.begin(), std::move(filter));
    }
    /// Whether it leaves all light as it is.
    bool empty() const { return filters_.empty(); }

    void filter(TileScratch& work, SurfacePoints& points, std::size_t light) const override {
        for (const auto& each : filters_) each->filter(work, points, light);
    }

  private:
    std::vector<std::unique_ptr<LightFilter>> filters_;
};

/// The light filters of a picture, by when they are asked.
struct LightFilters {
    FilterChain before;   ///< no shadow rays are sent where these leave no light
    FilterChain shadows;  ///< those that each lamp of an area light asks
    FilterChain behind;   ///< asked once for each light, whatever its shadows are

    /// Whether there are none.
    bool empty() const { return before.empty() && shadows.empty() && behind.empty(); }
    /// Asks them all about one light.
    void filter(TileScratch& work, SurfacePoints& points, std::size_t light) const {
        before.filter(work, points, light);
        shadows.filter(work, points, light);
        behind.filter(work, points, light);
    }
};

}  // namespace isoscope
