// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/function/patterns/pattern.h"
#include "core/scene/color.h"

namespace isoscope {

/// Colour all over.
struct SolidPigment {
    Color color{0, 0, 0, 0, 0};
    /// What this one colour stands for, when the scene asked for something that is not simulated
    /// ("projection"); empty when it asked for a colour.
    std::string standsFor;
};

struct ImageMap;
struct MappedPigment;
/// Immutable and shared, so that copies of an object cost nothing.
using Pigment = std::variant<SolidPigment, std::shared_ptr<const MappedPigment>>;

/// How the value of a pattern chooses among the entries.
enum class MapKind {
    blend,    ///< straight between the positions of neighbouring entries: color_map, pigment_map
    list,     ///< entry number n where the pattern is n: `checker color A color B`
    average,  ///< the mean of all entries by their positions, which are weights; the pattern only warps
    sides,    ///< of textures only: the first entry on the outside of the surface, the second on its inside
    surface   ///< of textures only: as the shape of Material::surface says
};

/// A pattern that chooses among pigments, which are looked up at the pattern's (warped) place as well.
struct MappedPigment {
    /// One pigment of the map and its place: a value of the pattern, or a weight (MapKind).
    struct Entry {
        double position = 0;
        Pigment pigment;
    };

    Pattern pattern;
    MapKind kind = MapKind::blend;
    std::vector<Entry> entries;  ///< empty: the pattern's own colours
    /// In place of a pattern and its map: the pattern only warps.
    std::shared_ptr<const ImageMap> image;
    bool onSurface = false;  ///< for `uv_mapping`: looked up at the place on the surface, <u, v, 0>

    /// Words of the scene that have no effect here ("map_type").
    std::vector<std::string> notSimulated;

    /// Pigments in it, counted as often as they are looked up, and the height of their tree: both are
    /// limited, because declared pigments may double with each line.
    std::size_t size = 1;
    int depth = 1;
    static constexpr std::size_t sizeLimit = 5'000;
    static constexpr int depthLimit = 50;
};

}  // namespace isoscope
