// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/isosurface_mesh.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include "core/mesh/contour/cell_refinement.h"
#include "core/mesh/contour/mesh_distance.h"
#include "core/mesh/contour/polygon_mesh.h"
#include "core/mesh/contour/surface_polygons.h"
#include "core/render/progressive/worker_pool.h"
#include "core/text/number_format.h"

namespace isoscope {

namespace {

/// The planes of the lattice lie so much of the tolerance inside of a box's walls.
constexpr double insetShare = 0.25;
/// Crossings are found to this part of the tolerance.
constexpr double crossingShare = 1e-3;
/// Cells are split until so much of the memory is taken: what is foreseen of the next ones may be too little.
constexpr double refinementShare = 0.85;
/// The usual tolerance, by the longest side.
constexpr double usualShare = 0.002;
/// A mesh is not asked to be closer than this part of the longest side: doubles and the lattice end.
constexpr double leastShare = 1e-5;

double longest(const glm::dvec3& size) { return std::max({size.x, size.y, size.z}); }

/// Why a container cannot be meshed; empty where it can.
std::string problemOf(const Container& container) {
    const glm::dvec3 size = sizeOf(container);
    const double most = longest(size), least = std::min({size.x, size.y, size.z});
    if (!(most < 1e100)) return "the container is not finite";
    if (!(least > 1e-6 * most)) return "the container has no volume, or is far flatter than it is long";
    return {};
}

class IsosurfaceMesher {
  public:
    IsosurfaceMesher(const Isosurface& surface, std::span<const double> parameters,
                     const MeshSettings& settings, double tolerance, std::stop_token stop)
        : tolerance_(tolerance),
          stop_(std::move(stop)),
          field_(surface, parameters),
          samplers_(field_),
          workers_(settings.threads),
          tree_(field_, insetOf(surface.settings().container)),
          samples_(field_, tree_, crossingShare * tolerance),
          refinement_(field_, tree_, samples_, limitsFor(settings), samplers_, workers_) {}

    IsosurfaceMesh run(const std::function<void(double)>& progress) {
        const double levels = std::log2(longest(tree_.sizeAt(0)) / tolerance_);
        refinement_.split(
            {0},
            [&](int level) {
                if (progress) progress(std::min(0.7, 0.7 * level / levels));
            },
            stop_);
        PolygonMesh made;
        MeshDistance distance;
        // What was split is looked at alone until it is near enough, then all again. This ends: each round
        // splits leaves, none beyond the finest.
        std::size_t before = 0;
        for (int round = 0;; ++round) {
            findForm(before);
            if (stop_.stop_requested() || tooLarge()) break;
            made = makeTriangles(surface_, field_, tree_, samples_, tolerance_, samplers_, workers_, stop_);
            distance = measureDistance(made, tolerance_, samplers_, workers_, stop_);
            if (progress) progress(1 - 0.3 * std::pow(0.6, round + 1));
            std::vector<std::uint32_t> coarse;
            if (!refinement_.limited()) coarse = coarseLeaves(distance.failing);
            if (stop_.stop_requested() || (coarse.empty() && before == 0)) break;
            before = coarse.empty() ? 0 : tree_.size();
            refinement_.split(std::move(coarse), {}, stop_);
        }
        if (stop_.stop_requested()) return {{}, {}, "stopped"};
        if (tooLarge()) return {{}, {}, tooLargeText(memory_), true};
        if (refinement_.shortage() == CellRefinement::Shortage::cells)
            return {{}, {}, "there are too few boxes for even a coarse mesh"};
        return finish(std::move(made), distance);
    }

  private:
    double insetOf(const Container& container) const {
        const glm::dvec3 size = sizeOf(container);
        return std::min(insetShare * tolerance_, 0.01 * std::min({size.x, size.y, size.z}));
    }
    RefinementLimits limitsFor(const MeshSettings& settings) {
        RefinementLimits limits;
        limits.tolerance = tolerance_;
        limits.cellLimit = settings.cellLimit;
        memory_ = settings.memory;
        limits.bytesOfTriangle = settings.bytesOfTriangle;
        limits.memory = static_cast<std::size_t>(refinementShare * static_cast<double>(memory_));
        const double levels = std::floor(std::log2(longest(tree_.sizeAt(0)) / tolerance_));
        limits.finest = static_cast<int>(std::clamp(levels, 3.0, double(CellOctree::deepest - 2)));
        limits.coarsest = std::min(limits.coarsest, limits.finest);
        limits.proven = std::min(limits.proven, limits.finest);
        // Where samples are too far off all the same cells go on to less than half of the tolerance: then
        // each point of the mesh is near enough to a crossing.
        finest_ = limits.finest + 2;
        return limits;
    }

    bool tooLarge() const {
        return refinement_.memory() > memory_ || refinement_.shortage() == CellRefinement::Shortage::memory;
    }

    /// Finds the polygons around the cells that came after the first `before`, all where there are none, and
    /// splits leaves until what bulges into one from a finer neighbour hangs together with the rest in it, or
    /// both are as fine. Around those that are split the same is done first.
    void findForm(std::size_t before) {
        for (std::size_t from = before; !stop_.stop_requested() && !tooLarge();) {
            around_ = from == 0 ? std::vector<std::uint32_t>() : leavesAround(tree_, from);
            surface_ = findPolygons(tree_, samples_, samplers_, around_);
            std::vector<std::uint32_t> parted;
            if (!refinement_.limited()) parted = partedLeaves();
            if (parted.empty() && from == before) break;
            from = parted.empty() ? before : tree_.size();
            refinement_.split(std::move(parted), {}, stop_);
        }
        if (tooLarge()) return;
        std::vector<MinimalEdge> edges;
        for (const SurfacePolygons::Polygon& polygon : surface_.polygons) edges.push_back(polygon.edge);
        samples_.needCrossings(edges, samplers_, workers_, stop_);
    }

    /// The leaves with several sheets of which one has an edge of a finer neighbour: a part of the solid that
    /// reaches through a face between the corners would be cut off there. In others the corners, which have
    /// been judged, make the sheets. Those beside such a leaf have edges of a finer neighbour once it is
    /// split.
    std::vector<std::uint32_t> partedLeaves() const {
        std::vector<std::uint8_t> sheets(tree_.size(), 0), seen = unasked();
        for (const std::uint32_t cell : surface_.cells) sheets[cell] = sheets[cell] == 0 ? 1 : 2;
        std::vector<std::uint32_t> vertices;  // of leaves with several sheets, leaf by leaf
        for (std::uint32_t vertex = 0; vertex < surface_.vertexCount(); ++vertex)
            if (sheets[surface_.cells[vertex]] > 1) vertices.push_back(vertex);
        const auto leafOf = [&](std::uint32_t vertex) { return surface_.cells[vertex]; };
        std::ranges::stable_sort(vertices, {}, leafOf);
        std::vector<std::uint32_t> leaves;
        const auto note = [&](std::uint32_t cell) {
            if (sheets[cell] > 1 && std::exchange(seen[cell], 1) == 0) leaves.push_back(cell);
        };
        for (const std::uint32_t vertex : vertices)
            forEachEdge(vertex, [&](const MinimalEdge& edge) {
                if (edge.level > tree_[leafOf(vertex)].level) note(leafOf(vertex));
            });
        for (std::size_t next = 0; next < leaves.size(); ++next) {
            const std::uint32_t leaf = leaves[next];
            // clang++ before its version 16 does not take the ranges of std::ranges::equal_range.
            for (auto at = std::ranges::lower_bound(vertices, leaf, {}, leafOf);
                 at != vertices.end() && leafOf(*at) == leaf; ++at)
                forEachEdge(*at, [&](const MinimalEdge& edge) {
                    for (const std::uint32_t cell : edge.cells)
                        if (tree_[cell].level <= tree_[leaf].level) note(cell);
                });
        }
        std::ranges::sort(leaves);
        return leaves;
    }
    /// 1 for the cells that the polygons are not known all around of.
    std::vector<std::uint8_t> unasked() const {
        std::vector<std::uint8_t> cells(tree_.size(), around_.empty() ? 0 : 1);
        for (const std::uint32_t leaf : around_) cells[leaf] = 0;
        return cells;
    }
    /// Calls visit(edge) for the edges of the polygons around a vertex.
    template <class Visit>
    void forEachEdge(std::uint32_t vertex, Visit visit) const {
        for (std::uint32_t i = surface_.firstCorner[vertex]; i < surface_.firstCorner[vertex + 1]; ++i)
            visit(surface_.polygons[surface_.corners[i].polygon].edge);
    }

    /// The largest leaves around polygons, those that may be split.
    std::vector<std::uint32_t> coarseLeaves(const std::vector<std::uint32_t>& polygons) const {
        const std::vector<std::uint8_t> unknown = unasked();
        std::vector<std::uint32_t> leaves;
        for (const std::uint32_t p : polygons) {
            const MinimalEdge& edge = surface_.polygons[p].edge;
            if (std::ranges::any_of(edge.cells, [&](std::uint32_t cell) { return unknown[cell] != 0; }))
                continue;
            int coarsest = finest_;
            for (const std::uint32_t cell : edge.cells)
                coarsest = std::min(coarsest, static_cast<int>(tree_[cell].level));
            for (const std::uint32_t cell : edge.cells)
                if (tree_[cell].level == coarsest && coarsest < finest_) leaves.push_back(cell);
        }
        std::sort(leaves.begin(), leaves.end());
        leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
        return leaves;
    }

    IsosurfaceMesh finish(PolygonMesh made, const MeshDistance& distance) {
        IsosurfaceMesh result;
        MeshReport& report = result.report;
        report.tolerance = tolerance_;
        report.distance = distance.most;
        report.samples = distance.samples;
        report.open = field_.open();
        report.limited = refinement_.limited();
        report.cells = tree_.size();
        for (const std::uint32_t p : made.polygonOf)
            if (samples_.crossing(surface_.polygons[p].edge).kind == CrossingKind::wall)
                ++report.wallTriangles;
        countDoubtful(report);
        if (field_.open()) separateFans(made.mesh);
        result.mesh = std::move(made.mesh);
        dropUnused(result.mesh);
        report.form = formOf(result.mesh);
        return result;
    }

    void countDoubtful(MeshReport& report) const {
        std::vector<bool> used(tree_.size(), false);
        for (const std::uint32_t cell : surface_.cells) used[cell] = true;
        for (std::size_t cell = 0; cell < tree_.size(); ++cell) {
            if (!tree_[cell].leaf() || tree_[cell].sign != 0 || used[cell]) continue;
            ++report.doubtfulCells;
            report.widestDoubtful = std::max(report.widestDoubtful, longest(tree_.sizeAt(tree_[cell].level)));
        }
    }

    /// Leaves out points and normals that no triangle has.
    static void dropUnused(TriangleMesh& mesh) {
        const auto pack = [](std::vector<glm::dvec3>& values, std::vector<Triangle>& users) {
            constexpr std::uint32_t none = ~std::uint32_t(0);
            std::vector<std::uint32_t> numbers(values.size(), none);
            std::vector<glm::dvec3> kept;
            for (Triangle& triangle : users)
                for (std::uint32_t& value : triangle) {
                    if (numbers[value] == none) {
                        numbers[value] = static_cast<std::uint32_t>(kept.size());
                        kept.push_back(values[value]);
                    }
                    value = numbers[value];
                }
            values = std::move(kept);
        };
        pack(mesh.points, mesh.triangles);
        pack(mesh.normals, mesh.cornerNormals);
    }

    double tolerance_;
    std::stop_token stop_;
    SolidField field_;
    SamplerPool samplers_;
    WorkerPool workers_;
    CellOctree tree_;
    CellSamples samples_;
    int finest_ = 0;
    std::size_t memory_ = 0;  ///< that may be taken
    CellRefinement refinement_;
    SurfacePolygons surface_;
    std::vector<std::uint32_t> around_;  ///< the leaves that it was found around; all, where there are none
};

}  // namespace

double usualTolerance(const Container& container) { return usualShare * longest(sizeOf(container)); }

void MeshReport::add(const MeshReport& other) {
    tolerance = std::max(tolerance, other.tolerance);
    distance = std::max(distance, other.distance);
    samples += other.samples;
    wallTriangles += other.wallTriangles;
    open = open || other.open;
    limited = limited || other.limited;
    cells += other.cells;
    doubtfulCells += other.doubtfulCells;
    widestDoubtful = std::max(widestDoubtful, other.widestDoubtful);
}

std::string tooLargeText(std::size_t memory) {
    return "the mesh would take more than " + std::to_string(memory / 1'000'000) +
           " MB of memory; a larger tolerance makes it smaller";
}

IsosurfaceMesh meshIsosurface(const Isosurface& surface, std::span<const double> parameters,
                              const MeshSettings& settings, const std::function<void(double)>& progress,
                              const std::stop_token& stop) {
    const Container& container = surface.settings().container;
    if (std::string problem = problemOf(container); !problem.empty()) return {{}, {}, std::move(problem)};
    const double side = longest(sizeOf(container));
    double tolerance = settings.tolerance;
    if (!(tolerance > 0) || !std::isfinite(tolerance)) tolerance = usualTolerance(container);
    if (tolerance < leastShare * side)
        return {{},
                {},
                "the tolerance is below " + shortestNumber(leastShare * side) +
                    ", a hundred thousandth of the container's longest side"};
    try {
        return IsosurfaceMesher(surface, parameters, settings, tolerance, stop).run(progress);
    } catch (const std::bad_alloc&) {
        return {{}, {}, "there is not enough memory for so fine a mesh"};
    }
}

}  // namespace isoscope
