// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/contour/surface_polygons.h"

#include <algorithm>
#include <tuple>

#include "core/mesh/joined_sets.h"

namespace isoscope {

namespace {

using Polygon = SurfacePolygons::Polygon;

/// Where a polygon passes the face between two leaves.
struct Passage {
    std::uint32_t low, high;  ///< the leaves, by their numbers
    std::uint32_t polygon;
    std::uint8_t quarter;                  ///< the passage leads from it to the next
    std::uint8_t lowQuarter, highQuarter;  ///< those that stand for the leaves

    bool sameFace(const Passage& other) const { return low == other.low && high == other.high; }
    std::uint32_t cornerOfLow() const { return 4 * polygon + lowQuarter; }
    std::uint32_t cornerOfHigh() const { return 4 * polygon + highQuarter; }
};

/// The first quarter of the same leaf.
std::uint8_t firstQuarter(const MinimalEdge& edge, unsigned quarter) {
    const unsigned before = (quarter + 3) % 4;
    return static_cast<std::uint8_t>(edge.cells[quarter] == edge.cells[before] ? before : quarter);
}

/// A face that more than two polygons pass.
struct DoubtfulFace {
    std::size_t first, end;  ///< of the passages
    unsigned axis;
    LatticePoint low;  ///< of the face
    std::uint32_t width;
};

class PolygonFinder {
  public:
    PolygonFinder(const CellOctree& tree, const CellSamples& samples, std::span<const std::uint32_t> leaves)
        : tree_(tree), samples_(samples), marks_(tree.size(), 0) {
        for (const std::uint32_t leaf : leaves) marks_[leaf] = markedAsked;
        if (leaves.empty()) std::fill(marks_.begin(), marks_.end(), markedAsked);
        for (std::uint32_t cell = 0; cell < tree_.size(); ++cell)
            if (tree_[cell].leaf()) marks_[cell] |= sidesOf(cell);
    }

    SurfacePolygons find(SolidSampler& sampler) {
        forEachMinimalEdge(tree_, marks_, [&](const MinimalEdge& edge) {
            const bool lowInside = samples_.endInside(edge, false);
            if (lowInside != samples_.endInside(edge, true)) result_.polygons.push_back({edge, lowInside});
        });
        findPassages();
        JoinedSets sheets(4 * result_.polygons.size());
        joinAcrossFaces(sheets);
        joinAcrossDoubtful(sheets, sampler);
        numberVertices(sheets);
        keepApart(sheets);
        return std::move(result_);
    }

  private:
    /// On which sides of the surface a leaf has corners.
    std::uint8_t sidesOf(std::uint32_t leaf) const {
        const std::int8_t sign = tree_[leaf].sign;
        const unsigned inside = sign == 0 ? samples_.cornersInside(leaf) : sign < 0 ? allCorners : 0;
        if (inside == 0) return markedOutside;
        return inside == allCorners ? markedInside : markedInside | markedOutside;
    }

    void findPassages() {
        for (std::uint32_t p = 0; p < result_.polygons.size(); ++p) {
            const MinimalEdge& edge = result_.polygons[p].edge;
            for (unsigned k = 0; k < 4; ++k) {
                const unsigned next = (k + 1) % 4;
                std::uint32_t from = edge.cells[k], to = edge.cells[next];
                if (from == to || ((marks_[from] | marks_[to]) & markedAsked) == 0) continue;
                std::uint8_t fromQuarter = firstQuarter(edge, k), toQuarter = firstQuarter(edge, next);
                if (from > to) {
                    std::swap(from, to);
                    std::swap(fromQuarter, toQuarter);
                }
                passages_.push_back({from, to, p, static_cast<std::uint8_t>(k), fromQuarter, toQuarter});
            }
        }
        std::sort(passages_.begin(), passages_.end(), [](const Passage& a, const Passage& b) {
            return std::tie(a.low, a.high, a.polygon) < std::tie(b.low, b.high, b.polygon);
        });
    }

    static void join(const Passage& a, const Passage& b, JoinedSets& sheets) {
        sheets.join(a.cornerOfLow(), b.cornerOfLow());
        sheets.join(a.cornerOfHigh(), b.cornerOfHigh());
    }

    void joinAcrossFaces(JoinedSets& sheets) {
        for (std::size_t first = 0; first < passages_.size();) {
            std::size_t end = first + 1;
            while (end < passages_.size() && passages_[end].sameFace(passages_[first])) ++end;
            if (end - first == 2)
                join(passages_[first], passages_[first + 1], sheets);
            else
                doubtful_.push_back(faceOf(first, end));
            first = end;
        }
    }

    DoubtfulFace faceOf(std::size_t first, std::size_t end) const {
        const Cell& a = tree_[passages_[first].low];
        const Cell& b = tree_[passages_[first].high];
        const Cell& small = a.level >= b.level ? a : b;
        const Cell& large = a.level >= b.level ? b : a;
        DoubtfulFace face{first, end, 0, small.low, CellOctree::width(small)};
        for (unsigned axis = 0; axis < 3; ++axis) {
            const bool above = small.low[axis] + face.width == large.low[axis];
            if (!above && large.low[axis] + CellOctree::width(large) != small.low[axis]) continue;
            face.axis = axis;
            if (above) face.low[axis] += face.width;
        }
        return face;
    }

    /// Where on the way round a face a polygon's edge lies, beginning at its low corner, and whether the
    /// corner before it is inside.
    struct Stop {
        std::uint64_t way;
        bool insideBefore;
        std::size_t passage;
    };
    Stop stopOf(const DoubtfulFace& face, std::size_t passage) const {
        const Polygon& polygon = result_.polygons[passages_[passage].polygon];
        const unsigned u = (face.axis + 1) % 3, v = (face.axis + 2) % 3;
        const LatticePoint low = polygon.edge.low, high = polygon.edge.high();
        const std::uint64_t side = 2 * std::uint64_t(face.width);
        const std::uint64_t atU = std::uint64_t(low[u]) + high[u] - 2 * std::uint64_t(face.low[u]);
        const std::uint64_t atV = std::uint64_t(low[v]) + high[v] - 2 * std::uint64_t(face.low[v]);
        if (polygon.edge.axis == u)
            return atV == 0 ? Stop{atU, polygon.lowInside, passage}
                            : Stop{2 * side + (side - atU), !polygon.lowInside, passage};
        return atU == 0 ? Stop{3 * side + (side - atV), !polygon.lowInside, passage}
                        : Stop{side + atV, polygon.lowInside, passage};
    }

    /// Where the middle of a face lies inside, what is inside hangs together there, else what is outside.
    void joinAcrossDoubtful(JoinedSets& sheets, SolidSampler& sampler) {
        std::vector<glm::dvec3> middles;
        for (const DoubtfulFace& face : doubtful_) {
            LatticePoint far = face.low;
            far[(face.axis + 1) % 3] += face.width;
            far[(face.axis + 2) % 3] += face.width;
            middles.push_back(0.5 * (tree_.place(face.low) + tree_.place(far)));
        }
        std::vector<std::uint8_t> inside(middles.size());
        sampler.inside(middles, inside);
        for (std::size_t i = 0; i < doubtful_.size(); ++i) {
            std::vector<Stop> stops;
            for (std::size_t k = doubtful_[i].first; k < doubtful_[i].end; ++k)
                stops.push_back(stopOf(doubtful_[i], k));
            std::sort(stops.begin(), stops.end(), [](const Stop& a, const Stop& b) { return a.way < b.way; });
            for (std::size_t k = 0; k < stops.size(); ++k) {
                const Stop& next = stops[(k + 1) % stops.size()];
                if (next.insideBefore == (inside[i] != 0)) continue;
                join(passages_[stops[k].passage], passages_[next.passage], sheets);
                joinedPairs_.push_back({stops[k].passage, next.passage});
            }
        }
    }

    void numberVertices(JoinedSets& sheets) {
        std::vector<std::uint32_t> numbers(4 * result_.polygons.size(), SurfacePolygons::none);
        std::vector<std::uint32_t> counts;
        forEachCorner([&](std::uint32_t p, unsigned k) {
            std::uint32_t& number = numbers[sheets.find(4 * p + k)];
            if (number == SurfacePolygons::none) {
                number = static_cast<std::uint32_t>(result_.cells.size());
                result_.cells.push_back(result_.polygons[p].edge.cells[k]);
                counts.push_back(0);
            }
            result_.polygons[p].vertices[k] = number;
            ++counts[number];
        });
        result_.firstCorner.assign(1, 0);
        for (const std::uint32_t count : counts)
            result_.firstCorner.push_back(result_.firstCorner.back() + count);
        result_.corners.resize(result_.firstCorner.back());
        std::vector<std::uint32_t> next(result_.firstCorner.begin(), result_.firstCorner.end() - 1);
        forEachCorner([&](std::uint32_t p, unsigned k) {
            result_.corners[next[result_.polygons[p].vertices[k]]++] = {p, static_cast<std::uint8_t>(k)};
        });
    }
    template <class Visit>
    void forEachCorner(Visit visit) const {
        for (std::uint32_t p = 0; p < result_.polygons.size(); ++p)
            for (unsigned k = 0; k < 4; ++k)
                if (firstQuarter(result_.polygons[p].edge, k) == k) visit(p, k);
    }

    /// Lines across one face between the same two vertices get a vertex of their own in the middle.
    void keepApart(JoinedSets& sheets) {
        for (std::size_t i = 0; i < joinedPairs_.size(); ++i)
            for (std::size_t k = i + 1; k < joinedPairs_.size() &&
                                        passages_[joinedPairs_[k][0]].sameFace(passages_[joinedPairs_[i][0]]);
                 ++k) {
                const Passage& a = passages_[joinedPairs_[i][0]];
                const Passage& b = passages_[joinedPairs_[k][0]];
                if (sheets.find(a.cornerOfLow()) != sheets.find(b.cornerOfLow()) ||
                    sheets.find(a.cornerOfHigh()) != sheets.find(b.cornerOfHigh()))
                    continue;
                for (const std::size_t pair : {i, k}) giveMiddle(joinedPairs_[pair]);
            }
    }
    void giveMiddle(const std::array<std::size_t, 2>& pair) {
        const Passage& a = passages_[pair[0]];
        const Passage& b = passages_[pair[1]];
        std::uint32_t& middle = result_.polygons[a.polygon].middles[a.quarter];
        if (middle != SurfacePolygons::none) return;
        middle = static_cast<std::uint32_t>(result_.middles.size());
        result_.polygons[b.polygon].middles[b.quarter] = middle;
        result_.middles.push_back({a.polygon, b.polygon});
    }

    const CellOctree& tree_;
    const CellSamples& samples_;
    std::vector<std::uint8_t> marks_;  ///< CellMark of the cells
    SurfacePolygons result_;
    std::vector<Passage> passages_;
    std::vector<DoubtfulFace> doubtful_;
    std::vector<std::array<std::size_t, 2>> joinedPairs_;  ///< passages across doubtful faces
};

}  // namespace

SurfacePolygons findPolygons(const CellOctree& tree, const CellSamples& samples, SamplerPool& samplers,
                             std::span<const std::uint32_t> leaves) {
    const SamplerPool::Loan sampler(samplers);
    return PolygonFinder(tree, samples, leaves).find(*sampler);
}

std::vector<std::uint32_t> leavesAround(const CellOctree& tree, std::size_t before) {
    std::vector<std::uint8_t> marks(tree.size(), markedOutside | markedInside);
    std::fill(marks.begin() + static_cast<std::ptrdiff_t>(before), marks.end(), markedFully);
    std::vector<std::uint32_t> leaves;
    for (int ring = 0; ring < 2; ++ring) {
        for (const std::uint32_t leaf : leaves) marks[leaf] = markedFully;
        forEachMinimalEdge(tree, marks, [&](const MinimalEdge& edge) {
            leaves.insert(leaves.end(), edge.cells.begin(), edge.cells.end());
        });
        std::sort(leaves.begin(), leaves.end());
        leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
    }
    return leaves;
}

}  // namespace isoscope
