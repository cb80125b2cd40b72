// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <variant>

#include "core/numeric/aligned_column.h"
#include "core/roots/line_columns.h"
#include "core/shapes/rays/ray.h"
#include "core/shapes/rays/ray_batch.h"

namespace isoscope {

/// An axis-parallel box in the coordinates of the shape, walls included. Isosurfaces sort swapped corners.
struct ContainerBox {
    glm::dvec3 low{-1};
    glm::dvec3 high{1};
};
/// A ball in the coordinates of the shape, wall included; one of radius 0 holds no part of any line.
struct ContainerSphere {
    glm::dvec3 center{0};
    double radius = 1;
};
/// Where the function of an isosurface is looked at.
using Container = std::variant<ContainerBox, ContainerSphere>;

/// Where the lines of many rays pass a container. Keeps its memory from call to call.
class ContainerPassages {
  public:
    /// Replaces all passages; the answers are those of sphereRange() and boxRange() (line_interval.h), bit
    /// for bit.
    void find(const Container& container, std::span<const Ray> rays);
    void find(const Container& container, const RayBatch& rays);

    /// Cuts what lies behind the rays' beginnings. Rays that are to end before their line is inside pass by.
    /// `ends` goes on for LineColumns::padding.
    void beginWithRays(std::size_t rays, const double* ends);

    /// Where the line of ray i is inside.
    RayInterval range(std::size_t i) const { return {near_[i], far_[i]}; }
    /// The ends of all ranges, column by column, with LineColumns::padding.
    const AlignedColumn& near() const { return near_; }
    const AlignedColumn& far() const { return far_; }
    /// The container's outward normal where the line of `ray`, number i, enters or leaves.
    glm::dvec3 wallNormal(const Container& container, const Ray& ray, std::size_t i, bool entering) const;
    /// The wall's normal for ray i of `rays`.
    glm::dvec3 wallNormal(const Container& container, const RayBatch& rays, std::size_t i,
                          bool entering) const;
    /// The wall's normals for many rays, which must pass: coordinate c of number k goes to normals[c][k], for
    /// whole vectors.
    void wallNormals(const Container& container, const RayBatch& rays, std::span<const std::size_t> lines,
                     bool entering, std::array<AlignedColumn, 3>& normals) const;

  private:
    void makeRoom(const Container& container, std::size_t rays);
    int wallAxis(std::size_t i, bool entering) const {
        return static_cast<int>(entering ? nearAxis_[i] : farAxis_[i]);
    }

    AlignedColumn near_, far_;
    AlignedColumn nearAxis_, farAxis_;  ///< of a box: across whose face
};

}  // namespace isoscope
