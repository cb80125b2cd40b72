// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/roots/cells/crossing_settler.h"
#include "core/roots/cells/union_parts.h"
#include "core/roots/certified/certain_starts.h"
#include "core/roots/certified/march_kernel.h"
#include "core/roots/certified/newton_polish.h"
#include "core/roots/column_table.h"
#include "core/roots/first_roots.h"

namespace isoscope {

/// The first roots of tiles of lines for unions whose parts lie in small boxes (UnionParts): each part is
/// searched for by itself, by its own tape, along the lines that meet its box and have met nothing before it.
/// The first root of the union is the first of these.
class PartMarch {
  public:
    /// The references must outlive the march.
    PartMarch(const UnionParts& parts, MarchKernel& march, NewtonPolish& polish, CrossingSettler& settler);

    /// Whether there is anything to be searched in this way.
    bool possible() const { return !parts_.empty(); }

    /// Searches up to batchLanes lines from `first` on, all of `bundle`: those whose roots count in front of
    /// fars[k], minus infinity where none is asked for. That is what fars[k] becomes where all is known;
    /// lines that begin inside, or are not plain in another way, are left as they were.
    void run(const LineColumns& lines, std::size_t first, std::size_t count, const LineBundle& bundle,
             double sufficient, double* fars, FirstRoots& roots);

  private:
    /// What is known of a line.
    enum class Outcome : std::uint8_t {
        none,      ///< nothing has been met
        crossing,  ///< in the list of crossings
        settled,   ///< at its place in settled_
        wall,      ///< where it enters
        notPlain   ///< left to others
    };

    void begin(const LineColumns& lines, std::size_t first, std::size_t count, const double* fars);
    void gather(const LineColumns& lines, std::size_t first, std::size_t count, const LineRegion& box);
    void search(const SimplifiedTape& tape, double sufficient, std::size_t first, FirstRoots& roots);
    void end(std::size_t i, Outcome outcome);

    const UnionParts& parts_;
    MarchKernel& march_;
    NewtonPolish& polish_;
    CrossingSettler& settler_;
    std::vector<UnionParts::Meeting> meetings_;

    // Of each line of the tile.
    std::array<std::array<double, batchLanes>, 3> perSpeed_{};  ///< 1 / direction
    std::array<double, batchLanes> reach_{};                    ///< in front of which roots still count
    std::array<Outcome, batchLanes> outcomes_{};
    std::array<FirstRoots::Other, batchLanes> settled_{};
    // Of the lines that meet the box of a part, side by side.
    enum Column : std::size_t { originX, directionX = 3, near = 6, far, columnCount };
    ColumnTable<columnCount> met_;
    std::vector<std::size_t> numbers_;  ///< in the tile
    CertainStarts starts_;
    FirstRoots found_;
    std::vector<std::uint8_t> leaving_;  ///< whether the crossing found leads outside
};

}  // namespace isoscope
