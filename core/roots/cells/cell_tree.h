// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
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
    struct Cell;
    /// What a cell is cut into.
    struct Division {
        std::vector<Cell*> children;
        DecidedChoices decided;             ///< all over the box of the cell
        std::vector<LaneChoices> choices;   ///< what else is decided in each of the children,
        std::vector<std::uint32_t> places;  ///< and the places of these choices
    };
    /// A cell with a box around it.
    struct Cell {
        glm::dvec3 center{0};
        double halfWidth = 0;  ///< of the box
        double sign = 0;       ///< the certain sign of the function all over it, negative inside, or 0
        /// Holds all over the box. Null where the sign is positive, and while nothing asks for it.
        const SimplifiedTape* tape = nullptr;
        std::unique_ptr<const SimplifiedTape> ownTape;
        std::optional<std::size_t> length;  ///< of its tape, once it was made
        std::uint64_t lastUse = 0;
        std::uint32_t points = 0;  ///< that were asked for in it and in none of its children
        const Cell* parent = nullptr;
        std::size_t number = 0;  ///< among the children of its parent
        std::unique_ptr<Division> division;

        /// Up to which t a bundle that is in the box at some t stays in it, at most to its end.
        double exit(const LineBundle& bundle) const;
    };

    /// The references must outlive the tree.
    CellTree(const PreparedFunction& function, const RootSettings& settings);

    /// To be called before lines of this bundle are looked for. Cells are kept if settings.region tells where
    /// they are to be, and while there is room for more.
    void begin(const LineBundle& bundle);

    /// A cell whose box holds the bundle at `t`: the smallest one such that the bundle has some way to go in
    /// it, or a larger one whose tape is short or whose sign is certain. Valid until the next one is asked
    /// for.
    const Cell& find(const LineBundle& bundle, double t);

    /// To be called once before points are asked for, in the place of begin(). False where that is no use:
    /// settings.region is not told, or has no size.
    bool beginPoints();
    /// A cell whose box holds a point of settings.region; null for others, and for those that are asked for
    /// so far only by a few: the whole tape holds there. Cells are divided when they have cost as much as
    /// that does, and as long as it makes tapes shorter. Valid until the next one is asked for.
    const Cell* at(const glm::dvec3& point);

    /// The tape that holds everywhere.
    const SimplifiedTape& whole() const { return links_.whole(); }
    /// Boxes enclosed so far.
    std::uint64_t evaluations() const { return boxes_.evaluations(); }
    /// BoxPieces::work() so far.
    std::uint64_t work() const { return boxes_.work(); }

  private:
    void beginIn(const LineRegion& region);
    static Cell& childAt(const Cell& cell, std::size_t count, const glm::dvec3& place);
    std::size_t partsOf(const Cell& cell) const;
    bool isWorthDividing(Cell& cell);
    void divide(Cell& cell);
    void decide(const Cell& cell, DecidedChoices& decided) const;
    const SimplifiedTape& tapeOf(Cell& cell);
    bool isLong(Cell& cell);
    void makeTape(Cell& cell, SimplifiedTape& tape);
    void keepTape(Cell& cell);
    void dropTapes();

    const RootSettings& settings_;
    const TapeLinks& links_;
    BoxPieces boxes_;
    LineRegion region_;
    std::deque<Cell> cells_;         ///< the root first
    SimplifiedTape made_;            ///< that of one cell, which need not be kept
    const Cell* madeFor_ = nullptr;  ///< that cell
    DecidedChoices decided_;
    std::vector<Cell*> kept_;       ///< cells that have a tape of their own
    std::size_t instructions_ = 0;  ///< of these
    std::uint64_t uses_ = 0;        ///< of these so far
    std::size_t memory_ = 0;        ///< of cells and their divisions, in bytes
};

}  // namespace isoscope
