// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/evaluate/affine_evaluator.h"
#include "core/roots/certified/march_lanes.h"

namespace isoscope {

/// Steps of the march along functions that jump: a piece that is undecided because it may hold jumps is
/// enclosed once more for each case, that is each combination of their sides (CaseLanes). All of them on one
/// side of the threshold: there is no root. Else the piece ends where the first jump may be, so that a jump
/// costs a few steps and no bisection.
class CaseMarch {
  public:
    /// Pieces with more jumps than these are shortened at once: 2 to that power are the enclosures of a
    /// piece. The last ones, which cannot be shortened, may take more.
    static constexpr int mostJumps = 3, mostJumpsAtLast = 5;

    /// Begins another list of lines: whether cases pay is found out anew.
    void reset() { tried_ = decided_ = 0; }

    /// As isoscope::march(), given `forms` to enclose the function by.
    bool step(AffineEvaluator& forms, RayPieces& pieces, MarchLanes& lanes, const SignRule& rule,
              std::size_t count, MarchEvent* events);

  private:
    /// A lane whose piece is undecided, and where its first jump may be.
    struct Undecided {
        std::size_t lane;
        double start, length;
        double first, last;
        std::size_t cases;
        int sign = 0;  ///< of all cases so far
        bool decided = true;
    };

    void collect(const RayPieces& pieces, MarchLanes& lanes, double threshold, std::size_t count);
    void tryCases(AffineEvaluator& forms, const RayPieces& pieces, double threshold);
    void runCases(AffineEvaluator& forms, double threshold, std::size_t count);
    void shorten(const Undecided& at, RayPieces& pieces, MarchLanes& lanes) const;

    /// Where hardly one of many pieces is decided by its cases, no more are tried.
    bool pays() const { return tried_ < 512 || 32 * decided_ > tried_; }

    std::array<MarchLanes::Lanes, 3> forms_;
    CaseLanes cases_;
    std::vector<Undecided> undecided_;
    RayPieces sidePieces_;
    std::uint64_t tried_ = 0, decided_ = 0;        ///< pieces of this list
    std::array<std::size_t, batchLanes> owner_{};  ///< the entry of undecided_ that a lane of them is of
};

}  // namespace isoscope
