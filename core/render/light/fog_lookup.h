// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/scene/scene.h"
#include "core/shapes/rays/ray.h"
#include "core/texture/tape_lookup.h"

namespace isoscope {

/// What the fogs of a scene leave of the light on many ways: the turbulence of all ways is looked up
/// together.
class FogLookup {
  public:
    /// The scratch memory of one thread.
    class Work : public ShapeState {
      public:
        explicit Work(std::span<const double> parameters) : lookup_(parameters) {}

      private:
        friend class FogLookup;

        struct Way {
            Ray ray;
            double distance;
        };

        TapeLookup lookup_;
        std::vector<Way> ways_;
        std::vector<double> turbulence_;  ///< of each way, fog by fog
    };

    /// The scene must outlive this.
    explicit FogLookup(const Scene& scene);

    /// The state of one thread; `parameters` is the scene's parameter table, which is copied.
    std::unique_ptr<Work> makeWork(std::span<const double> parameters) const {
        return std::make_unique<Work>(parameters);
    }

    /// Ways are numbered from 0 on, since the last begin().
    void begin(Work& work) const { work.ways_.clear(); }
    /// A ray of unit direction up to a distance, which may be infinite.
    void add(const Ray& ray, double distance, Work& work) const { work.ways_.push_back({ray, distance}); }
    /// To be called when all ways are known. Returns how many values it has looked up.
    std::size_t findTurbulence(Work& work) const;
    /// How much light the fog, one of the scene's, leaves on a way unscattered: between Fog::color.transmit
    /// and 1. NaN where the depth is none.
    double left(std::size_t fog, std::size_t way, const Work& work) const;

  private:
    const Scene& scene_;
    std::vector<std::shared_ptr<const Tape>> turbulences_;  ///< of each fog, null where it has none
};

}  // namespace isoscope
