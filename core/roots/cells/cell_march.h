// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/numeric/aligned_column.h"
#include "core/roots/certified/certain_starts.h"
#include "core/roots/cells/box_pieces.h"
#include "core/roots/cells/cell_tree.h"
#include "core/roots/cells/crossing_settler.h"
#include "core/roots/cells/part_march.h"
#include "core/roots/certified/line_bundle.h"
#include "core/roots/certified/newton_polish.h"
#include "core/roots/certified/march_kernel.h"
#include "core/roots/certified/root_polish.h"
#include "core/roots/cells/short_tapes.h"
#include "core/roots/first_roots.h"

namespace isoscope {

class PreparedFunction;

/// The first roots of many lines for functions full of choices (unions of many parts). Unions of small parts
/// are searched part by part (PartMarch); of other functions, and of what that leaves, tiles of lines go from
/// cell to cell of a CellTree, front to back. What may hold a root in a cell is cut into pieces with still
/// shorter tapes, which hold only what decides there whether a point is inside; lines march by those alone
/// (docs/evaluation.md).
class CellMarch {
  public:
    /// Lines of a tile.
    static constexpr std::size_t tileLines = batchLanes;

    /// What lines march with; the references must outlive the march.
    struct Tools {
        const RootSettings& settings;
        AffineEvaluator& forms;
        MarchKernel& march;
        NewtonPolish& polish;
        RootPolish& fallback;  ///< for what the first leaves
        GradientEvaluator& gradients;
        LazyUnionParts& parts;
    };

    /// `function` is what the tools evaluate; it must outlive the march.
    CellMarch(const PreparedFunction& function, const Tools& tools);

    /// Whether the tape can become short at all.
    bool worthwhile() const { return shortTapes_.possible(); }

    /// What became of a run. Unless it is `done`, roots and rest() tell nothing, and the caller searches the
    /// lines otherwise.
    enum class Outcome {
        nothingAsked,  ///< all lines are empty, or have nothing in common
        vain,          ///< tapes do not become short enough to be worth their making
        done
    };

    /// The first roots of lines of which nothing is known. Lines that are neither in `roots` nor in rest()
    /// have none.
    Outcome run(const LineColumns& lines, double sufficient, const std::stop_token& stop, FirstRoots& roots);

    /// Lines searched by a run that was done.
    std::size_t searched() const { return searched_; }
    /// What the last run has left over: lines to be searched further by the whole tape.
    const std::vector<MarchKernel::Line>& rest() const { return rest_; }

  private:
    struct Tile {
        std::size_t first = 0, count = 0;  ///< its lines
        std::size_t open = 0;              ///< those of them that go on
        LineBundle bundle;
        /// Lines that go on are outside the solid up to here, but for those that have begun inside.
        double clearTo = -std::numeric_limits<double>::infinity();
        bool hasInside = false;  ///< some are inside at clearTo: those with a negative sign
    };

    /// Pieces that a tile's way through a cell is cut into.
    static constexpr std::size_t depth = 8;

    void cutTiles(const LineColumns& lines);
    bool pays();
    bool makesShort(const CellTree::Cell& cell, const LineBundle& bundle, const DepthRange& range);
    void searchParts(const LineColumns& lines, Tile& tile, double sufficient, FirstRoots& roots);
    void search(const LineColumns& lines, Tile& tile, double sufficient, FirstRoots& roots);
    void searchCell(const LineColumns& lines, const CellTree::Cell& cell, Tile& tile, const DepthRange& range,
                    double sufficient, FirstRoots& roots);
    void enclosePieces(const CellTree::Cell& cell, const LineBundle& bundle, const DepthRange& range);
    std::size_t joinPieces(std::size_t first) const;
    void skip(Tile& tile, const DepthRange& range);
    void march(const LineColumns& lines, Tile& tile, const DepthRange& range, const SimplifiedTape& tape,
               double sufficient, FirstRoots& roots);
    void takeResults(MarchKernel::Results& found, const LineColumns& lines, Tile& tile,
                     const SimplifiedTape& tape, FirstRoots& roots);
    std::uint64_t work() const { return work_ + tree_.work() + pieces_.work(); }
    void close(std::size_t line, Tile& tile);

    Tools tools_;
    ShortTapes shortTapes_;
    CellTree tree_;
    BoxPieces pieces_;
    CrossingSettler settler_;
    std::optional<PartMarch> parts_;  ///< made by the first run
    std::vector<Tile> tiles_;
    SimplifiedTape pieceTape_;
    CertainStarts starts_;
    AlignedColumn fars_;  ///< where lines that go on end; before anything for the others
    AlignedColumn ends_;  ///< how far they are searched for now
    std::size_t searched_ = 0;
    std::uint64_t work_ = 0;  ///< of marches: so many instructions for one line
    std::vector<MarchKernel::Line> rest_;
};

}  // namespace isoscope
