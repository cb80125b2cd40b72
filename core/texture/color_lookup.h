// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <vector>

#include "core/scene/material.h"
#include "core/texture/image_map.h"
#include "core/texture/surface_place.h"
#include "core/texture/tape_lookup.h"

namespace isoscope {

/// Colours of pigments at many points: collects questions, and answers those about one pigment together.
/// Keeps scratch memory: one object per thread.
class ColorLookup {
  public:
    explicit ColorLookup(std::span<const double> parameters) : lookup_(parameters) {}

    /// What colour the material's pigment, which must have a tape, has at a point outside. The answer bears
    /// `number`, which should be small.
    void ask(const Material& material, const glm::dvec3& point, std::size_t number) {
        ask(material, point, number, [] { return SurfacePlace(); });
    }

    /// The same; `surface` is called for what some pigments know besides.
    template <class Surface>
    void ask(const Material& material, const glm::dvec3& point, std::size_t number, Surface surface) {
        const glm::dvec3 place = material.pigmentTransform.inversePoint(point);
        if (needsSurface(*material.pigmentTape)) {
            lookup_.ask(material.pigmentTape, surfaceArguments(place, glm::dvec3(0), surface()), number);
        } else {
            const double arguments[] = {place.x, place.y, place.z};
            lookup_.ask(material.pigmentTape, arguments, number);
        }
        if (images_.size() <= number) images_.resize(number + 1);
        images_[number] = material.image.get();
    }

    /// Calls visit(number, colour) for every question since the last time; returns how many there were. No
    /// channel is NaN or infinite: 0 stands in its place.
    template <class Visit>
    std::size_t answer(Visit visit) {
        return lookup_.answer([&](std::size_t number, std::span<const double> results) {
            if (const ImageMap* image = images_[number])
                return visit(number, imageColor(*image, {results[0], results[1], results[2]}));
            const auto channel = [&](std::size_t k) { return std::isfinite(results[k]) ? results[k] : 0; };
            visit(number, Color{channel(0), channel(1), channel(2), channel(3), channel(4)});
        });
    }

  private:
    TapeLookup lookup_;
    std::vector<const ImageMap*> images_;
};

}  // namespace isoscope
