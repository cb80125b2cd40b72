// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/contour/minimal_edges.h"

#include <initializer_list>

namespace isoscope {

namespace {

/// Around an edge along some axis: those behind and before it along the next axis (fastest) and the one
/// after that.
using Around = std::array<std::uint32_t, 4>;

class EdgeWalk {
  public:
    EdgeWalk(const CellOctree& tree, std::span<const std::uint8_t> marks,
             const std::function<void(const MinimalEdge&)>& visit)
        : tree_(tree), marks_(marks), visit_(visit) {}

    void inCell(std::uint32_t cell) {
        const Cell& here = tree_[cell];
        if (here.leaf() || !marked({cell})) return;
        for (std::uint32_t k = 0; k < 8; ++k) inCell(here.firstChild + k);
        for (unsigned axis = 0; axis < 3; ++axis) {
            const unsigned along = 1u << axis, next = 1u << (axis + 1) % 3, last = 1u << (axis + 2) % 3;
            for (unsigned k = 0; k < 4; ++k) {
                const unsigned across = ((k & 1) != 0 ? next : 0) | ((k & 2) != 0 ? last : 0);
                acrossFace(axis, here.firstChild + across, here.firstChild + across + along);
            }
            for (const unsigned part : {0u, along})
                aroundEdge(axis, {here.firstChild + part, here.firstChild + part + next,
                                  here.firstChild + part + last, here.firstChild + part + next + last});
        }
    }

  private:
    /// A child that touches what is walked, or the leaf itself.
    std::uint32_t part(std::uint32_t cell, unsigned number) const {
        return tree_[cell].leaf() ? cell : tree_[cell].firstChild + number;
    }
    /// Whether some cells have all marks together.
    bool marked(std::initializer_list<std::uint32_t> cells) const {
        unsigned marks = 0;
        for (const std::uint32_t cell : cells) marks |= marks_[cell];
        return marks == markedFully;
    }

    /// Two cells that share a face across `axis`.
    void acrossFace(unsigned axis, std::uint32_t low, std::uint32_t high) {
        if ((tree_[low].leaf() && tree_[high].leaf()) || !marked({low, high})) return;
        const unsigned across = 1u << axis, next = (axis + 1) % 3, last = (axis + 2) % 3;
        for (unsigned k = 0; k < 4; ++k) {
            const unsigned number = ((k & 1) << next) | ((k >> 1) << last);
            acrossFace(axis, part(low, number | across), part(high, number));
        }
        // Edges inside of the face: along `next` the plane's other axis is `last`, and round it come `last`,
        // then `axis`; along `last` come `axis`, then `next`.
        for (unsigned half = 0; half < 2; ++half) {
            const unsigned alongNext = half << next, alongLast = half << last;
            aroundEdge(next, {part(low, alongNext | across), part(low, alongNext | across | 1u << last),
                              part(high, alongNext), part(high, alongNext | 1u << last)});
            aroundEdge(last,
                       {part(low, alongLast | across), part(high, alongLast),
                        part(low, alongLast | across | 1u << next), part(high, alongLast | 1u << next)});
        }
    }

    void aroundEdge(unsigned axis, const Around& cells) {
        if (!marked({cells[0], cells[1], cells[2], cells[3]})) return;
        bool leaves = true;
        for (const std::uint32_t cell : cells) leaves = leaves && tree_[cell].leaf();
        if (leaves) return visitEdge(axis, cells);
        const unsigned next = 1u << (axis + 1) % 3, last = 1u << (axis + 2) % 3;
        for (const unsigned half : {0u, 1u << axis})
            aroundEdge(axis, {part(cells[0], half | next | last), part(cells[1], half | last),
                              part(cells[2], half | next), part(cells[3], half)});
    }

    void visitEdge(unsigned axis, const Around& cells) {
        unsigned smallest = 0;
        for (unsigned k = 1; k < 4; ++k)
            if (tree_[cells[k]].level > tree_[cells[smallest]].level) smallest = k;
        const Cell& cell = tree_[cells[smallest]];
        MinimalEdge edge;
        edge.axis = static_cast<std::uint8_t>(axis);
        edge.level = cell.level;
        edge.low = cell.low;
        if ((smallest & 1) == 0) edge.low[(axis + 1) % 3] += CellOctree::width(cell);
        if ((smallest & 2) == 0) edge.low[(axis + 2) % 3] += CellOctree::width(cell);
        edge.cells = {cells[0], cells[1], cells[3], cells[2]};
        visit_(edge);
    }

    const CellOctree& tree_;
    std::span<const std::uint8_t> marks_;
    const std::function<void(const MinimalEdge&)>& visit_;
};

}  // namespace

std::uint64_t MinimalEdge::key() const {
    LatticePoint end = high();
    return CellOctree::twiceKey(std::uint64_t(low.x) + end.x, std::uint64_t(low.y) + end.y,
                                std::uint64_t(low.z) + end.z);
}

void forEachMinimalEdge(const CellOctree& tree, std::span<std::uint8_t> marks,
                        const std::function<void(const MinimalEdge&)>& visit) {
    // Children follow their parents.
    for (std::size_t cell = tree.size(); cell-- > 0;) {
        if (tree[cell].leaf()) continue;
        marks[cell] = 0;
        for (std::uint32_t k = 0; k < 8; ++k) marks[cell] |= marks[tree[cell].firstChild + k];
    }
    EdgeWalk(tree, marks, visit).inCell(0);
}

}  // namespace isoscope
