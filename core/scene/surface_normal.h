// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/scene/pigment.h"

namespace isoscope {

/// How a `normal { ... }` turns the normal of a surface.
enum class NormalKind {
    pattern,  ///< by the slope of the pattern (through slope_map, where there is one)
    bumps,    ///< and the next five by formulas of their own
    dents,
    quilted,
    ripples,
    waves,
    wrinkles,
    image,  ///< `bump_map`: by the grey of SurfaceNormal::image
    map,    ///< the entries of a normal_map or list, chosen by the pattern
    facets  ///< the same all over a cell of crackle (FacetSettings)
};

/// An entry of a `slope_map`: height and slope at a position.
struct SlopeEntry {
    double position = 0;
    double height = 0;
    double slope = 0;
};

/// `facets size S coords C`: flat places of a size of about S. Without C normals are those of a few
/// directions, in S for the length of a step; else they are bent by C times a random vector for each place.
struct FacetSettings {
    double size = 0.1;  ///< nothing is bent by one that is not above 0
    double coords = 0;
};

/// A `normal { ... }`: immutable and shared.
struct SurfaceNormal {
    /// One normal of the map and its place: a value of the pattern, or a weight (MapKind).
    struct Entry {
        double position = 0;
        std::shared_ptr<const SurfaceNormal> normal;  ///< null: the shape's own
    };

    NormalKind kind = NormalKind::pattern;
    bool flat = false;  ///< no pattern has been named: it only holds settings for those that begin from it
    Pattern pattern;
    double amount = 0.5;
    double accuracy = 0.02;
    bool scaled = true;  ///< the bumps grow with transformations; false for `no_bump_scale`
    FacetSettings facets;
    std::vector<SlopeEntry> slopes;
    std::shared_ptr<const ImageMap> image;
    bool onSurface = false;  ///< as MappedPigment::onSurface
    MapKind mapKind = MapKind::blend;
    std::vector<Entry> entries;

    /// As MappedPigment::size and MappedPigment::depth.
    std::size_t size = 1;
    int depth = 1;
};

}  // namespace isoscope
