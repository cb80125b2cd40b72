// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/contour/polygon_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/mesh/contour/vertex_places.h"

namespace isoscope {

namespace {

using Polygon = SurfacePolygons::Polygon;

/// Triangles may be so far from the crossing, by the tolerance, before a point is put there.
constexpr double fanShare = 0.5;
/// A crossing that is a point of the mesh keeps this way, by the edge's length, from its ends.
constexpr double leastShare = 1e-4;

/// How a polygon is cut.
enum class Cut : std::uint8_t { left_out, triangle, diagonal02, diagonal13, fan };

/// The corners of a polygon in order, seen from outside against the clock, by points of the mesh.
struct Ring {
    std::array<std::uint32_t, 8> points{};
    std::size_t size = 0;
    bool hasMiddles = false;
};

class Triangulation {
  public:
    Triangulation(const SurfacePolygons& surface, const SolidField& field, const CellSamples& samples,
                  VertexPlaces places, double tolerance)
        : surface_(surface),
          field_(field),
          samples_(samples),
          smooth_(std::move(places.smooth)),
          tolerance_(tolerance) {
        result_.mesh.points = std::move(places.points);
        result_.mesh.normals = std::move(places.normals);
        result_.offCrossing.assign(surface.polygons.size(), 0);
        for (const Polygon& polygon : surface.polygons)
            result_.crossings.push_back(samples.placeOf(polygon.edge, samples.crossing(polygon.edge)));
        addMiddles();
    }

    PolygonMesh make() {
        cuts_.resize(surface_.polygons.size());
        for (std::size_t p = 0; p < surface_.polygons.size(); ++p) cuts_[p] = cutOf(p);
        separateDiagonals();
        for (std::size_t p = 0; p < surface_.polygons.size(); ++p) cut(p);
        return std::move(result_);
    }

  private:
    glm::dvec3 crossingOf(std::size_t p) const {
        const MinimalEdge& edge = surface_.polygons[p].edge;
        CellSamples::EdgeCrossing crossing = samples_.crossing(edge);
        crossing.share = std::clamp(crossing.share, leastShare, 1 - leastShare);
        return samples_.placeOf(edge, crossing);
    }
    glm::dvec3 normalOf(std::size_t p) const {
        return glm::dvec3(samples_.crossing(surface_.polygons[p].edge).normal);
    }

    void addMiddles() {
        firstMiddle_ = static_cast<std::uint32_t>(result_.mesh.points.size());
        for (const std::array<std::uint32_t, 2>& two : surface_.middles) {
            result_.mesh.points.push_back(0.5 * (crossingOf(two[0]) + crossingOf(two[1])));
            const glm::dvec3 sum = normalOf(two[0]) + normalOf(two[1]);
            const double length = glm::length(sum);
            result_.mesh.normals.push_back(length > 1e-9 ? sum / length : normalOf(two[0]));
            smooth_.push_back(1);
        }
    }

    Ring ringOf(std::size_t p) const {
        const Polygon& polygon = surface_.polygons[p];
        Ring ring;
        for (unsigned k = 0; k < 4; ++k) {
            if (polygon.vertices[k] != SurfacePolygons::none) ring.points[ring.size++] = polygon.vertices[k];
            if (polygon.middles[k] == SurfacePolygons::none) continue;
            ring.points[ring.size++] = firstMiddle_ + polygon.middles[k];
            ring.hasMiddles = true;
        }
        // Quarters go round the axis by the right-hand rule, which is right where the outside is above.
        if (!polygon.lowInside)
            std::reverse(ring.points.begin(), ring.points.begin() + static_cast<std::ptrdiff_t>(ring.size));
        return ring;
    }

    double distanceTo(const glm::dvec3& place, const Ring& ring, std::array<unsigned, 3> corners) const {
        const auto at = [&](unsigned k) { return result_.mesh.points[ring.points[corners[k]]]; };
        return distanceToTriangle(place, at(0), at(1), at(2));
    }
    bool faces(const glm::dvec3& normal, const Ring& ring, std::array<unsigned, 3> corners) const {
        const auto at = [&](unsigned k) { return result_.mesh.points[ring.points[corners[k]]]; };
        return glm::dot(normal, glm::cross(at(1) - at(0), at(2) - at(0))) > 0;
    }

    Cut cutOf(std::size_t p) {
        if (field_.open() && samples_.crossing(surface_.polygons[p].edge).kind == CrossingKind::wall)
            return Cut::left_out;
        const Ring ring = ringOf(p);
        if (ring.hasMiddles || ring.size < 3) return Cut::fan;
        const glm::dvec3 place = crossingOf(p), normal = normalOf(p);
        double& off = result_.offCrossing[p];
        Cut cut = Cut::triangle;
        bool faces03 = true;
        if (ring.size == 3) {
            off = distanceTo(place, ring, {0, 1, 2});
        } else {
            const double off02 =
                std::min(distanceTo(place, ring, {0, 1, 2}), distanceTo(place, ring, {0, 2, 3}));
            const double off13 =
                std::min(distanceTo(place, ring, {0, 1, 3}), distanceTo(place, ring, {1, 2, 3}));
            const bool faces02 = faces(normal, ring, {0, 1, 2}) && faces(normal, ring, {0, 2, 3});
            const bool faces13 = faces(normal, ring, {0, 1, 3}) && faces(normal, ring, {1, 2, 3});
            const bool first = faces02 != faces13 ? faces02 : off02 <= off13;
            cut = first ? Cut::diagonal02 : Cut::diagonal13;
            off = first ? off02 : off13;
            faces03 = faces02 || faces13;
        }
        if (faces03 && off <= fanShare * tolerance_) return cut;
        off = 0;
        return Cut::fan;
    }

    /// Of polygons that are cut between the same two points each gets a point in its middle.
    void separateDiagonals() {
        struct Diagonal {
            std::uint32_t low, high, polygon;
        };
        std::vector<Diagonal> diagonals;
        for (std::size_t p = 0; p < cuts_.size(); ++p) {
            if (cuts_[p] != Cut::diagonal02 && cuts_[p] != Cut::diagonal13) continue;
            const Ring ring = ringOf(p);
            const std::size_t from = cuts_[p] == Cut::diagonal02 ? 0 : 1;
            const auto [low, high] = std::minmax(ring.points[from], ring.points[from + 2]);
            diagonals.push_back({low, high, static_cast<std::uint32_t>(p)});
        }
        std::sort(diagonals.begin(), diagonals.end(), [](const Diagonal& a, const Diagonal& b) {
            if (a.low != b.low) return a.low < b.low;
            return a.high != b.high ? a.high < b.high : a.polygon < b.polygon;
        });
        for (std::size_t i = 1; i < diagonals.size(); ++i)
            if (diagonals[i].low == diagonals[i - 1].low && diagonals[i].high == diagonals[i - 1].high)
                cuts_[diagonals[i].polygon] = cuts_[diagonals[i - 1].polygon] = Cut::fan;
    }

    void cut(std::size_t p) {
        if (cuts_[p] == Cut::left_out) return;
        const Ring ring = ringOf(p);
        sharpNormal_ = none;
        if (cuts_[p] == Cut::fan) {
            const auto center = static_cast<std::uint32_t>(result_.mesh.points.size());
            result_.mesh.points.push_back(crossingOf(p));
            centerNormal_ = normalNumber(p);
            for (std::size_t k = 0; k < ring.size; ++k)
                add(p, {ring.points[k], ring.points[(k + 1) % ring.size], center});
        } else if (cuts_[p] == Cut::triangle) {
            add(p, {ring.points[0], ring.points[1], ring.points[2]});
        } else if (cuts_[p] == Cut::diagonal02) {
            add(p, {ring.points[0], ring.points[1], ring.points[2]});
            add(p, {ring.points[0], ring.points[2], ring.points[3]});
        } else {
            add(p, {ring.points[0], ring.points[1], ring.points[3]});
            add(p, {ring.points[1], ring.points[2], ring.points[3]});
        }
    }

    std::uint32_t normalNumber(std::size_t p) {
        if (sharpNormal_ == none) {
            sharpNormal_ = static_cast<std::uint32_t>(result_.mesh.normals.size());
            result_.mesh.normals.push_back(normalOf(p));
        }
        return sharpNormal_;
    }
    void add(std::size_t p, const Triangle& triangle) {
        Triangle normals;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t point = triangle[k];
            normals[k] = point >= smooth_.size() ? centerNormal_
                         : smooth_[point] != 0   ? point
                                                 : normalNumber(p);
        }
        result_.mesh.triangles.push_back(triangle);
        result_.mesh.cornerNormals.push_back(normals);
        result_.polygonOf.push_back(static_cast<std::uint32_t>(p));
    }

    static constexpr std::uint32_t none = ~std::uint32_t(0);

    const SurfacePolygons& surface_;
    const SolidField& field_;
    const CellSamples& samples_;
    std::vector<std::uint8_t> smooth_;  ///< of the vertices and middles
    double tolerance_;
    PolygonMesh result_;
    std::vector<Cut> cuts_;
    std::uint32_t firstMiddle_ = 0;
    // Of the polygon at hand.
    std::uint32_t sharpNormal_ = none;
    std::uint32_t centerNormal_ = none;
};

}  // namespace

PolygonMesh makeTriangles(const SurfacePolygons& surface, const SolidField& field, const CellOctree& tree,
                          const CellSamples& samples, double tolerance, SamplerPool& samplers,
                          WorkerPool& workers, const std::stop_token& stop) {
    VertexPlaces places = placeVertices(surface, field, tree, samples, tolerance, samplers, workers, stop);
    if (stop.stop_requested()) return {};
    return Triangulation(surface, field, samples, std::move(places), tolerance).make();
}

double distanceToTriangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                          const glm::dvec3& c) {
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double area = glm::length(normal);
    const auto toSide = [&](const glm::dvec3& from, const glm::dvec3& to) {
        const glm::dvec3 way = to - from;
        const double square = glm::dot(way, way);
        const double share = square > 0 ? std::clamp(glm::dot(p - from, way) / square, 0.0, 1.0) : 0;
        return glm::distance(p, from + share * way);
    };
    const bool above = area > 0 && glm::dot(glm::cross(b - a, p - a), normal) >= 0 &&
                       glm::dot(glm::cross(c - b, p - b), normal) >= 0 &&
                       glm::dot(glm::cross(a - c, p - c), normal) >= 0;
    if (above) return std::abs(glm::dot(p - a, normal)) / area;
    return std::min({toSide(a, b), toSide(b, c), toSide(c, a)});
}

}  // namespace isoscope
