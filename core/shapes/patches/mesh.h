// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/shapes/patches/triangle_hit.h"
#include "core/shapes/rays/bvh.h"
#include "core/shapes/shape.h"

namespace isoscope {

/// Many triangles in one tree. Neighbours leave no gaps: see TriangleLine.
class Mesh : public Shape {
  public:
    /// A triangle: indices into the points and, when it is smooth, into the normals of its corners.
    struct Face {
        std::array<std::uint32_t, 3> corners{};
        std::array<std::uint32_t, 3> normals{};
        bool smooth = false;
        std::array<std::uint32_t, 3> places{};    ///< on the texture, one for each corner, if there are any
        std::array<std::uint32_t, 3> textures{};  ///< as Shape::textureShares; between corners they blend
    };

    /// Faces refer to the points and normals by index; all indices must be valid. With an inside direction,
    /// which must not be 0, points from which a ray in that direction meets an odd number of triangles are
    /// inside; without one, no point is.
    /// `places` are u and v of corners.
    Mesh(std::vector<glm::dvec3> points, std::vector<glm::dvec3> normals, std::vector<Face> faces,
         std::optional<glm::dvec3> insideDirection, std::vector<glm::dvec2> places = {});

    /// Faces as given to the constructor, those without area included.
    std::size_t faceCount() const { return faces_.size(); }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    void nearest(std::span<const Ray> rays, TraceContext& context,
                 std::span<NearestHit> nearest) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    bool isPatch() const override { return !insideDirection_; }
    /// Other patches cut off what they are taken from by their bounds; in POV-Ray, meshes do not.
    Bounds complementWithin(const Bounds& room) const override { return room; }
    Bounds bounds() const override { return bounds_; }
    std::optional<glm::dvec2> surfacePlace(const glm::dvec3& point) const override;
    std::vector<TextureShare> textureShares(const glm::dvec3& point) const override;

  private:
    /// The face that a point of the surface lies on, and where.
    struct Spot {
        const Face* face = nullptr;  ///< null: none is near
        glm::dvec3 shares{0};
    };
    Spot spotOf(const glm::dvec3& point) const;
    std::optional<TriangleHit> meet(const TriangleLine& line, std::size_t face) const;
    glm::dvec3 normalAt(std::size_t face, const TriangleHit& met) const;

    std::vector<glm::dvec3> points_;
    std::vector<glm::dvec3> normals_;
    std::vector<Face> faces_;
    std::vector<glm::dvec2> places_;
    std::optional<glm::dvec3> insideDirection_;
    Bvh tree_;
    Bounds bounds_;
};

}  // namespace isoscope
