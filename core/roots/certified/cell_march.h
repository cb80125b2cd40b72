// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <span>
#include <stop_token>
#include <vector>

#include "core/numeric/aligned_column.h"
#include "core/roots/certified/certain_starts.h"
#include "core/roots/certified/choice_pieces.h"
#include "core/roots/certified/line_bundle.h"
#include "core/roots/certified/newton_polish.h"
#include "core/roots/certified/march_kernel.h"
#include "core/roots/first_roots.h"

namespace isoscope {

class PreparedFunction;

/// The first roots of many lines for functions full of choices (unions of many parts). All lines together are
/// cut into ranges of depth, and each range gets a tape of its own, which holds only what decides there
/// whether a point is inside. In every range, front to back, tiles of lines are cut into cells with still
/// shorter tapes; lines march only through cells that may hold a root (docs/evaluation.md). After Duff,
/// "Interval arithmetic and recursive subdivision for implicit functions and constructive solid geometry"
/// (1992).
class CellMarch {
  public:
    static constexpr std::size_t tileLines = batchLanes;
    /// Ranges of depth.
    static constexpr std::size_t slabs = ChoicePieces::slabs;
    /// Cells of a tile in a depth range.
    static constexpr std::size_t depth = 4;

    /// What lines march with; the references must outlive the march.
    struct Tools {
        const RootSettings& settings;
        AffineEvaluator& forms;
        MarchKernel& march;
        NewtonPolish& polish;
    };

    /// `function` is what the tools evaluate; it must outlive the march.
    CellMarch(const PreparedFunction& function, const Tools& tools);

    /// Whether the tape can become short at all.
    bool worthwhile() const { return pieces_.worthwhile(); }

    /// What became of a run. Unless it is `done`, roots, rest() and unsettled() tell nothing, and the caller
    /// searches the lines otherwise.
    enum class Outcome {
        nothingAsked,  ///< all lines are empty, or have nothing in common
        vain,          ///< tapes do not become short; nothing is done
        done
    };

    /// The first roots of lines of which nothing is known. Lines that are neither in `roots` nor in the lists
    /// below have none.
    Outcome run(const LineColumns& lines, double sufficient, const std::stop_token& stop, FirstRoots& roots);

    /// Lines searched by a run that was done.
    std::size_t searched() const { return searched_; }
    /// What the last run has left over: lines to be searched further by the whole tape, and crossings for
    /// which the polish has not settled.
    const std::vector<MarchKernel::Line>& rest() const { return rest_; }
    const std::vector<NewtonPolish::Unsettled>& unsettled() const { return unsettled_; }

  private:
    struct Tile {
        std::size_t first = 0, count = 0;  ///< its lines
        std::size_t open = 0;              ///< those of them that go on
        LineBundle bundle;
        /// Lines that go on are outside the solid up to here, but for those that have begun inside.
        double clearTo = -std::numeric_limits<double>::infinity();
        bool hasInside = false;  ///< some are inside at clearTo: those with a negative sign
    };
    struct Slab {
        DepthRange range;
        bool clear = false;  ///< the function is positive all over it
        SimplifiedTape tape;
    };
    struct Cell {
        Tile* tile = nullptr;
        DepthRange range;
    };
    static constexpr std::size_t tilesAtOnce = batchLanes / depth;

    void cutSlabs(const LineBundle& bundle);
    void cutTiles(const LineColumns& lines);
    bool pays();
    std::size_t placeCells(std::span<Tile> tiles, const DepthRange& range);
    /// Whether the function is positive all over the piece of this lane.
    bool isClear(std::size_t lane) const { return pieces_.sign(lane) > 0; }
    std::size_t joinCells(std::size_t first, std::size_t count) const;
    void searchSlab(const LineColumns& lines, const Slab& slab, double sufficient, FirstRoots& roots);
    void skip(Tile& tile, const DepthRange& range);
    void march(const LineColumns& lines, Tile& tile, const DepthRange& range, double sufficient,
               FirstRoots& roots);
    void takeResults(MarchKernel::Results& found, const LineColumns& lines, Tile& tile, FirstRoots& roots);
    void close(std::size_t line, Tile& tile);

    Tools tools_;
    ChoicePieces pieces_;
    std::array<Slab, slabs> slabs_;
    std::vector<Tile> tiles_;
    std::array<Cell, batchLanes> cells_;
    SimplifiedTape cellTape_;
    CertainStarts starts_;
    AlignedColumn fars_;  ///< where lines that go on end; before anything for the others
    AlignedColumn ends_;  ///< how far they are searched for now
    std::size_t searched_ = 0;
    std::vector<MarchKernel::Line> rest_;
    std::vector<NewtonPolish::Unsettled> unsettled_;
};

}  // namespace isoscope
