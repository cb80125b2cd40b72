// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/contour/vertex_places.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/mesh/contour/quadric_fit.h"
#include "core/render/progressive/worker_pool.h"

namespace isoscope {

namespace {

constexpr std::size_t verticesOfBatch = 256;
/// Normals of a smooth vertex are at least this like their mean: 25 degrees.
constexpr double smoothCosine = 0.906;
/// The margin between a vertex and the next leaf, of the leaf's width and of the tolerance.
constexpr double marginOfLeaf = 0.005, marginOfTolerance = 0.02;
/// A move to the surface may be so long, by the width of the leaf.
constexpr double longestMove = 0.5;

struct Room {
    glm::dvec3 low, high;
};

class VertexPlacing {
  public:
    VertexPlacing(const SurfacePolygons& surface, const SolidField& field, const CellOctree& tree,
                  const CellSamples& samples, double tolerance)
        : surface_(surface), field_(field), tree_(tree), samples_(samples), tolerance_(tolerance) {
        result_.points.resize(surface.vertexCount());
        result_.normals.resize(surface.vertexCount());
        result_.smooth.resize(surface.vertexCount());
    }

    void place(std::size_t first, std::size_t end, SolidSampler& sampler) {
        std::vector<std::size_t> moving;
        QuadricFit fit;
        for (std::size_t vertex = first; vertex < end; ++vertex)
            if (fitOne(vertex, fit)) moving.push_back(vertex);
        for (int step = 0; step < 2; ++step) moveToSurface(moving, sampler, step == 1);
    }

    /// Vertices of one leaf that lie at one place go back to the middles of their crossings.
    VertexPlaces finish() {
        std::vector<std::uint32_t> order(surface_.vertexCount());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(i);
        std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return surface_.cells[a] < surface_.cells[b];
        });
        for (std::size_t i = 1; i < order.size(); ++i)
            for (std::size_t k = i; k-- > 0 && surface_.cells[order[k]] == surface_.cells[order[i]];) {
                const Cell& cell = tree_[surface_.cells[order[i]]];
                const double close = marginOfLeaf * glm::length(tree_.high(cell) - tree_.low(cell));
                if (glm::distance(result_.points[order[i]], result_.points[order[k]]) > close) continue;
                for (const std::uint32_t vertex : {order[i], order[k]})
                    result_.points[vertex] = middleOf(vertex);
            }
        return std::move(result_);
    }

  private:
    Room roomOf(std::size_t vertex) const {
        const Cell& cell = tree_[surface_.cells[vertex]];
        const glm::dvec3 low = tree_.low(cell), high = tree_.high(cell);
        const glm::dvec3 margin =
            glm::min(marginOfLeaf * (high - low), glm::dvec3(marginOfTolerance * tolerance_));
        return {low + margin, high - margin};
    }
    void gather(std::size_t vertex, QuadricFit& fit, int& walls, int& jumps) const {
        fit.clear();
        for (std::uint32_t i = surface_.firstCorner[vertex]; i < surface_.firstCorner[vertex + 1]; ++i) {
            const MinimalEdge& edge = surface_.polygons[surface_.corners[i].polygon].edge;
            const CellSamples::EdgeCrossing& crossing = samples_.crossing(edge);
            fit.add(samples_.placeOf(edge, crossing), glm::dvec3(crossing.normal));
            walls += crossing.kind == CrossingKind::wall ? 1 : 0;
            jumps += crossing.kind == CrossingKind::jump ? 1 : 0;
        }
    }
    glm::dvec3 middleOf(std::size_t vertex) const {
        QuadricFit fit;
        int walls = 0, jumps = 0;
        gather(vertex, fit, walls, jumps);
        const Room room = roomOf(vertex);
        return glm::clamp(fit.middle(), room.low, room.high);
    }

    /// Whether the vertex is to be moved to the level set.
    bool fitOne(std::size_t vertex, QuadricFit& fit) {
        int walls = 0, jumps = 0;
        gather(vertex, fit, walls, jumps);
        const Room room = roomOf(vertex);
        const int planes = static_cast<int>(fit.planes());
        const bool smooth = fit.leastCosine() > smoothCosine && (walls == 0 || walls == planes);
        result_.normals[vertex] = fit.meanNormal();
        result_.smooth[vertex] = smooth ? 1 : 0;
        glm::dvec3 point =
            smooth ? glm::clamp(fit.middle(), room.low, room.high) : fit.solve(room.low, room.high);
        if (smooth && walls == planes) {
            // Onto the wall.
            const glm::dvec3 normal = field_.wallNormal(point);
            point = glm::clamp(point + field_.depth(point) * normal, room.low, room.high);
            result_.normals[vertex] = normal;
        }
        result_.points[vertex] = point;
        return smooth && walls == 0 && jumps == 0;
    }

    /// One step of Newton's method along the gradient; the last one takes the normals there.
    void moveToSurface(std::span<const std::size_t> vertices, SolidSampler& sampler, bool last) {
        std::vector<glm::dvec3> points;
        for (const std::size_t vertex : vertices) points.push_back(result_.points[vertex]);
        std::vector<ValueAndGradient> slopes(points.size());
        sampler.gradients(points, slopes);
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const std::size_t vertex = vertices[i];
            const glm::dvec3 slope(slopes[i].gradient[0], slopes[i].gradient[1], slopes[i].gradient[2]);
            const double square = glm::dot(slope, slope);
            if (!(square > 0) || !std::isfinite(square) || !std::isfinite(slopes[i].value)) continue;
            const glm::dvec3 normal = slope / std::sqrt(square);
            if (glm::dot(normal, result_.normals[vertex]) < 0.5) continue;
            if (last) result_.normals[vertex] = normal;
            const glm::dvec3 move = -slopes[i].value / square * slope;
            const Room room = roomOf(vertex);
            if (!(glm::length(move) < longestMove * glm::length(room.high - room.low))) continue;
            result_.points[vertex] = glm::clamp(points[i] + move, room.low, room.high);
        }
    }

    const SurfacePolygons& surface_;
    const SolidField& field_;
    const CellOctree& tree_;
    const CellSamples& samples_;
    double tolerance_;
    VertexPlaces result_;
};

}  // namespace

VertexPlaces placeVertices(const SurfacePolygons& surface, const SolidField& field, const CellOctree& tree,
                           const CellSamples& samples, double tolerance, SamplerPool& samplers,
                           WorkerPool& workers, const std::stop_token& stop) {
    VertexPlacing placing(surface, field, tree, samples, tolerance);
    const std::size_t count = surface.vertexCount();
    workers.run((count + verticesOfBatch - 1) / verticesOfBatch, [&](std::size_t batch) {
        if (stop.stop_requested()) return;
        const SamplerPool::Loan sampler(samplers);
        const std::size_t first = batch * verticesOfBatch;
        placing.place(first, std::min(count, first + verticesOfBatch), *sampler);
    });
    return placing.finish();
}

}  // namespace isoscope
