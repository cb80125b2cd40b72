// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <stop_token>
#include <vector>

#include "core/roots/cells/choice_pieces.h"
#include "core/roots/certified/general_search_lanes.h"
#include "core/roots/cells/short_tapes.h"
#include "core/roots/cells/part_tapes.h"
#include "core/roots/line_query.h"

namespace isoscope {

class PreparedFunction;

/// The search along neighbouring lines for functions full of choices (unions of many parts): tiles of lines
/// times ranges of depth. One enclosure of a tile in a range tells which choices are decided there, and the
/// lines are searched range by range with tapes that hold only what the sign of the function depends on there
/// (docs/evaluation.md). What is decided alike for all lines and ranges is left out first, and of unions of
/// small parts those whose boxes the lines do not meet (UnionParts).
class SlabSearch {
  public:
    static constexpr std::size_t tileLines = batchLanes;
    /// Ranges of depth.
    static constexpr std::size_t slabs = ChoicePieces::slabs;

    /// `function` is what tools.forms evaluates and `parts` are of; both must outlive the search.
    SlabSearch(const PreparedFunction& function, const SearchTools& tools, PartTapes& parts);
    // The search refers to its tapes.
    SlabSearch(const SlabSearch&) = delete;
    SlabSearch& operator=(const SlabSearch&) = delete;

    /// Whether the tape can become short at all.
    bool worthwhile() const { return shortTapes_.possible(); }

    /// Whether tapes become short along these lines, going by all of them, else by the first tile of wanted
    /// ones: the clamps of a fractal sum, for one, are decided everywhere, and nearly all of the sum is left.
    /// To be asked before begin(), which is for parts of these lines.
    bool pays(std::span<const LineQuery> queries, std::span<const std::uint8_t> wanted);

    static constexpr std::size_t batchLines = tileLines * (batchLanes / slabs);

    /// Encloses up to batchLines lines from `first` on, those that are wanted. Returns whether most choices
    /// are decided; if not, the lines are better searched with the whole tape.
    bool begin(std::span<const LineQuery> queries, std::span<const std::uint8_t> wanted, std::size_t first);

    /// Holds all along the lines of begin(); null for the whole tape.
    const SimplifiedTape* tape() const { return holds_ ? &batchTape_ : nullptr; }

    /// starts[i] becomes what is certain about the beginning of line i, for the lines of begin() that are
    /// enclosed.
    void noteStarts(CertainStarts& starts) const;

    /// Searches these lines, with enclosures from `allowance`. done(line, search, end sign) is called as by
    /// GeneralSearchLanes::step; missed(line, sign) for a line whose function is known to have one sign all
    /// along.
    template <class Done, class Missed>
    void run(std::span<const LineQuery> queries, std::span<const std::uint8_t> wanted, double sufficient,
             SearchAllowance allowance, const std::stop_token& stop, Done done, Missed missed) {
        lanes_.allow(std::move(allowance));
        for (std::size_t tile = 0; tile < tilesAtOnce && !stop.stop_requested(); ++tile) {
            const CertainStart start = certainStart(tile);
            admit(tile, queries, wanted, sufficient, start, missed);
            if (!tiles_[tile].enclosed) searchSlab(queries, nullptr, stop, done);
            for (std::size_t slab = 0; slab < slabs && !lanes_.empty(); ++slab) {
                if (end(tile, slab) <= start.start) continue;
                if (const double sign = pieces_.sign(tile * slabs + slab); sign != 0)
                    lanes_.skipTo(end(tile, slab), sign, done);
                lanes_.limitTo(end(tile, slab));
                if (lanes_.active() == 0) continue;
                simplify(tile, slab);
                searchSlab(queries, &simplifiedTape_, stop, done);
            }
        }
    }

  private:
    static constexpr std::size_t tilesAtOnce = batchLanes / slabs;

    /// The lines [first, end) of a tile and the interval of their bundle. Lines that are no bundle (they
    /// point in opposite directions) are not enclosed: they are searched with the whole tape.
    struct Tile {
        std::size_t first = 0, end = 0;
        bool wanted = false;  ///< some of them are
        bool enclosed = false;
        DepthRange depth;
        LineBundle bundle;
    };

    bool enclose(std::span<const LineQuery> queries, std::span<const std::uint8_t> wanted, std::size_t first,
                 std::size_t count, std::size_t tile);
    bool becomesShort();
    void takeCommon();
    bool addMetParts();
    std::uint64_t enclosedLanes() const;
    double end(std::size_t tile, std::size_t slab) const {
        return tiles_[tile].depth.border(slab + 1, slabs);
    }
    CertainStart certainStart(std::size_t tile) const;
    void simplify(std::size_t tile, std::size_t slab);

    template <class Done>
    void searchSlab(std::span<const LineQuery> queries, const SimplifiedTape* simplifiedTape,
                    const std::stop_token& stop, Done done) {
        while (lanes_.active() > 0 && !stop.stop_requested()) lanes_.step(queries, simplifiedTape, done);
    }

    template <class Missed>
    void admit(std::size_t tile, std::span<const LineQuery> queries, std::span<const std::uint8_t> wanted,
               double sufficient, const CertainStart& start, Missed missed) {
        lanes_.clear();
        for (std::size_t i = tiles_[tile].first; i < tiles_[tile].end; ++i) {
            if (!wanted[i]) continue;
            if (start.sign != 0 && start.start >= queries[i].far)
                missed(i, start.sign);
            else
                lanes_.add(i, queries[i], sufficient, start);
        }
    }

    ShortTapes shortTapes_;
    ChoicePieces pieces_;
    PartTapes& parts_;
    GeneralSearchLanes lanes_;
    std::array<Tile, tilesAtOnce> tiles_;
    SimplifiedTape simplifiedTape_;
    SimplifiedTape commonTape_;               ///< what is left for all wanted lines of pays()
    const SimplifiedTape* common_ = nullptr;  ///< that one, or null for the whole tape
    SimplifiedTape batchTape_;                ///< what is left for all lines of begin(),
    bool holds_ = false;                      ///< if there is such a tape
};

}  // namespace isoscope
