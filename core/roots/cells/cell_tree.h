// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <glm/vec3.hpp>
#include <vector>

#include "core/roots/cells/box_pieces.h"
#include "core/roots/certified/line_bundle.h"
#include "core/roots/root_settings.h"

namespace isoscope {

class PreparedFunction;

/// What a function full of choices (a union of many parts) comes to in boxes of space: an octree whose cells
/// each have a tape that holds all over their box, shortened from the tape of the cell around them. Cells are
/// made when lines first come there, so that the cost follows what is seen. A cell depends on its place
/// alone, not on what was asked before. After Duff, "Interval arithmetic and recursive subdivision for
/// implicit functions and constructive solid geometry" (1992); boxes are twice as wide as their cells, so
/// that one of them holds a bundle wherever it is: Ulrich, "Loose octrees" (2000).
class CellTree {
  public:
    /// A cell with a box around it.
    struct Cell {
        glm::dvec3 center{0};
        double halfWidth = 0;  ///< of the box
        double sign = 0;       ///< the certain sign of the function all over it, negative inside, or 0
        /// Holds all over the box; null where the sign is positive.
        const SimplifiedTape* tape = nullptr;

        SimplifiedTape ownTape;
        std::vector<Cell*> children;       ///< none until they are asked for
        std::vector<LaneChoices> choices;  ///< what is decided in each of them

        /// Up to which t a bundle that is in the box at some t stays in it, at most to its end.
        double exit(const LineBundle& bundle) const;
    };

    /// The references must outlive the tree.
    CellTree(const PreparedFunction& function, const RootSettings& settings);

    /// To be called before lines of this bundle are looked for. Cells are kept if settings.region tells where
    /// they are to be, and while there is room for more.
    void begin(const LineBundle& bundle);

    /// A cell whose box holds the bundle at `t`: the smallest one such that the bundle has some way to go in
    /// it, or a larger one whose tape is short or whose sign is certain. Valid until begin().
    const Cell& find(const LineBundle& bundle, double t);

    /// The tape that holds everywhere.
    const SimplifiedTape& whole() const { return whole_; }
    /// Boxes enclosed so far.
    std::uint64_t evaluations() const { return boxes_.evaluations(); }
    /// BoxPieces::work() so far.
    std::uint64_t work() const { return boxes_.work(); }

  private:
    void divide(Cell& cell);
    void shorten(const Cell& parent, std::size_t child);

    const RootSettings& settings_;
    const SimplifiedTape& whole_;
    BoxPieces boxes_;
    LineRegion region_;
    std::deque<Cell> cells_;        ///< the root first
    std::size_t instructions_ = 0;  ///< of all cells
};

}  // namespace isoscope
