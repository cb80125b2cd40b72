// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/numeric/aligned_column.h"
#include "core/shapes/rays/hit_batch.h"
#include "core/shapes/rays/ray_batch.h"

namespace isoscope {

/// The places where rays of a batch have met something, coordinate by coordinate, so that vector instructions
/// can work on them: entry k of every list belongs to the same place. Behind the last place the columns go on
/// for a vector or more, with unspecified numbers. Lists keep their memory from batch to batch.
struct SurfacePoints {
    using Column = AlignedColumn;
    using Vectors = std::array<Column, 3>;  ///< x, y, z or red, green, blue

    /// As many entries may be read and written beyond the last.
    static constexpr std::size_t padding = 64;

    std::vector<std::uint32_t> samples;  ///< whose rays they are
    std::vector<MaterialId> materials;
    Vectors point;
    Vectors normal;   ///< as Hit::normal
    Vectors view;     ///< the direction of the ray, unit length
    Vectors pigment;  ///< colours of the materials that are patterned; else unspecified
    Vectors weight;   ///< what of `shine` counts, where textures have more than one part (`weighted`)
    bool weighted = false;
    /// Of what the textures have looked up (`lookedUp`), where `weighted` or the material is patterned: what
    /// comes through from behind (of layers at the lowest), and pigments as they are where nothing does.
    Vectors transmission, tint;
    bool lookedUp = false;
    Vectors straight;  ///< the shape's normal, turned to the viewer, where `lookedUp` and it is bent
    Column share;      ///< what of a mirror's light counts, where `weighted`
    std::vector<std::uint8_t> outermost;  ///< 1 for the top layer of each part, where `weighted`
    Column film;    ///< how thick the film of the material is, where that differs from place to place
    Vectors shine;  ///< what goes to the viewer, the sum over all lights so far

    // The light at hand.
    Vectors toLight;   ///< unit length
    Column distance;   ///< to the source (parallel light: to its plane)
    Column strength;   ///< after cone, tightness and distance; 0 where nothing arrives
    Vectors returned;  ///< what goes to the viewer of it

    /// Places, without the padding behind them.
    std::size_t size() const { return samples.size(); }

    /// Forgets the places; the columns keep their memory and their old numbers.
    void clear() {
        samples.clear();
        materials.clear();
        weighted = false;
        lookedUp = false;
    }

    /// Takes what the rays have found.
    void gather(const RayBatch& rays, const HitBatch& hits);

    /// Makes the columns long enough for so many places.
    void makeRoom(std::size_t points);
};

/// Entry k as one vector.
inline glm::dvec3 at(const SurfacePoints::Vectors& vectors, std::size_t k) {
    return {vectors[0][k], vectors[1][k], vectors[2][k]};
}

}  // namespace isoscope
