// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/shapes/shape.h"

namespace isoscope {

/// The places where rays of a batch have met something, coordinate by coordinate, so that vector instructions
/// can work on them: entry k of every list belongs to the same place. Behind the last place the columns go on
/// for a vector or more, with numbers of no meaning. Lists keep their memory from batch to batch.
struct SurfacePoints {
    using Column = std::vector<double>;
    using Vectors = std::array<Column, 3>;  ///< x, y, z or red, green, blue

    /// As many entries may be read and written beyond the last.
    static constexpr std::size_t padding = 64;

    std::vector<std::uint32_t> samples;  ///< whose rays they are
    std::vector<MaterialId> materials;
    Vectors point;
    Vectors normal;  ///< as Hit::normal
    Vectors view;    ///< the direction of the ray, unit length
    Vectors shine;   ///< what goes to the viewer, the sum over all lights so far

    // The light at hand.
    Vectors toLight;   ///< unit length
    Column distance;   ///< to the source (parallel light: to its plane)
    Column strength;   ///< after cone, tightness and distance; 0 where nothing arrives
    Vectors returned;  ///< what goes to the viewer of it

    std::size_t size() const { return samples.size(); }

    void clear() {
        samples.clear();
        materials.clear();
    }

    /// Takes what the rays have found.
    void gather(std::span<const Ray> rays, std::span<const NearestHit> nearest) {
        clear();
        const std::size_t room = rays.size() + padding;
        for (Vectors* vectors : {&point, &normal, &view, &shine, &toLight, &returned})
            for (Column& column : *vectors) makeRoom(column, room);
        makeRoom(distance, room);
        makeRoom(strength, room);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (!nearest[i].found) continue;
            const std::size_t k = samples.size();
            const Hit& hit = nearest[i].hit;
            samples.push_back(rays[i].sample);
            materials.push_back(hit.material);
            for (int c = 0; c < 3; ++c) {
                point[static_cast<std::size_t>(c)][k] = hit.point[c];
                normal[static_cast<std::size_t>(c)][k] = hit.normal[c];
                view[static_cast<std::size_t>(c)][k] = rays[i].direction[c];
            }
        }
    }

  private:
    static void makeRoom(Column& column, std::size_t room) {
        if (column.size() < room) column.resize(room);
    }
};

/// Entry k as one vector.
inline glm::dvec3 at(const SurfacePoints::Vectors& vectors, std::size_t k) {
    return {vectors[0][k], vectors[1][k], vectors[2][k]};
}

}  // namespace isoscope
