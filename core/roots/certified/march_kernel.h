// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/evaluate/affine_evaluator.h"
#include "core/roots/certified/certain_starts.h"
#include "core/roots/certified/march_lanes.h"
#include "core/roots/column_table.h"
#include "core/roots/first_roots.h"
#include "core/roots/line_columns.h"
#include "core/roots/root_settings.h"

namespace isoscope {

struct MarchRows;
struct PlainMarchRules;

/// Looks for the first root of many lines by enclosures, all of them side by side, as long as all is plain:
/// the sign of the function at the start of every piece becomes certain, and so does every change of it. The
/// steps are those of march(). What is not plain is left to GeneralSearch.
///
/// A function that jumps is enclosed on the sides of its jumps that hold at the start of a piece (SideLanes):
/// the piece ends where the first of them may end, and the next one begins there, on the sides that hold
/// right behind. Where the sign is another one by that, the function jumps through the threshold: a root.
class MarchKernel {
  public:
    /// The columns of `crossings`: a certain change of sign between low and high, at most `tolerance` apart,
    /// on a line that goes through (originX, ...) along (directionX, ...). `steepness` is as in
    /// BracketedRoot; `curvatureRatio` is the error of the enclosure that has found it, in parts of half the
    /// change along its piece: the function is no further from a straight line there.
    enum Crossing : std::size_t {
        foundLine,
        low,
        high,
        steepness,
        curvatureRatio,
        foundTolerance,
        foundOriginX,
        foundOriginY,
        foundOriginZ,
        foundDirectionX,
        foundDirectionY,
        foundDirectionZ,
        crossingColumns
    };
    using Crossings = ColumnTable<crossingColumns>;

    /// A line of the list, with how far it is certain.
    struct Line {
        std::size_t line = 0;
        CertainStart start;
    };

    /// The columns of the lines that are being marched along. `line` is -1 for those that have come to an
    /// end.
    enum Column : std::size_t {
        line,
        start,
        length,
        far,
        sign,
        watched,
        resolution,
        tolerance,
        hop,       ///< of functions that jump: from the start to where the sides of jumps hold for certain
        toldJump,  ///< the jump whose side behind it is told (SideLanes), or SideLanes::noJump: sides are
        toldSide,  ///< read behind the hop
        behind,    ///< and how long a piece may be behind a jump that short ones come near to; 0: not known
        originX,
        originY,
        originZ,
        directionX,
        directionY,
        directionZ,
        columnCount
    };
    using Columns = ColumnTable<columnCount>;

    /// What the march has come to; lines that are in none of the lists have no root.
    struct Results {
        Crossings crossings;
        /// Lines with a certain change of sign in their piece and no root before it, where the function seems
        /// so straight that its tangent tells the root. Only if they are asked for.
        Columns brackets;
        std::vector<std::size_t> entryWalls;   ///< lines that meet a wall first
        std::vector<FirstRoots::Other> jumps;  ///< first roots where the function jumps, or in the wall
        std::vector<std::size_t> insideEnds;   ///< lines that come to their end inside
        std::vector<Line> rest;                ///< lines to be searched further
    };

    /// The references must outlive the march.
    MarchKernel(AffineEvaluator& forms, const RootSettings& settings);

    /// Marches along the lines from where `starts` end. The results are the caller's to change until the next
    /// run. Roots before `sufficient` do not count; what comes there is left to others. With `brackets`, what
    /// a tangent can tell is left to the caller.
    Results& run(const LineColumns& lines, const CertainStarts& starts, double sufficient,
                 const std::stop_token& stop, bool brackets = false);
    /// Marches along `count` lines from `first` on, at most batchLanes, by a tape that holds along them.
    Results& run(const LineColumns& lines, std::size_t first, std::size_t count, const CertainStarts& starts,
                 double sufficient, const SimplifiedTape& simplifiedTape);
    /// Goes on along the lines that are left in the brackets of the last run, to crossings.
    void resume(const std::stop_token& stop);

    /// Lines searched by the last run.
    std::size_t searched() const { return searched_; }

    /// Whether it pays to look at pieces with jumps as a whole is found out anew.
    void restart() { wholePieces_ = undecidedPieces_ = 0; }

  private:
    /// How the pieces of lines are enclosed: as they are; of functions that jump also by the sides at their
    /// start; or as they are until a piece is undecided that way.
    enum class Pace { plain, untilUndecided, bySides };

    bool wholePays() const {
        return wholePieces_ < 1024 || 3 * (wholePieces_ - undecidedPieces_) > wholePieces_;
    }
    PlainMarchRules rules() const;
    void begin(double sufficient, const SimplifiedTape* simplifiedTape);
    void runGroup(const LineColumns& lines, const CertainStarts& starts, std::size_t first,
                  std::size_t count);
    void runGathered(const std::stop_token& stop);
    void runJumping(const std::stop_token& stop);
    void leaveRest(const Columns& columns);
    std::size_t step(const MarchRows& rows, std::size_t count);
    std::size_t stepSides(const MarchRows& rows, const PieceColumns& pieces, std::size_t count);

    AffineEvaluator& forms_;
    const RootSettings& settings_;
    const SimplifiedTape* simplifiedTape_ = nullptr;
    Columns group_;    ///< lines that are searched where they lie; no rays
    Columns columns_;  ///< those that are left of groups
    Results results_;
    std::size_t searched_ = 0;
    double sufficient_ = 0;
    bool brackets_ = false;
    Pace pace_ = Pace::plain;
    SideLanes sides_;
    Columns otherColumns_;  ///< of functions that jump: lines whose pieces are looked at at the other pace
    std::size_t wholePieces_ = 0, undecidedPieces_ = 0;  ///< since the restart
};

}  // namespace isoscope
