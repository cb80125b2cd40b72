// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/evaluate/affine_evaluator.h"
#include "core/evaluate/tape/tape_simplifier.h"
#include "core/roots/certified/line_bundle.h"
#include "core/roots/root_settings.h"

namespace isoscope {

class PreparedFunction;

/// Pieces of bundles, up to batchLanes side by side, with what functions full of choices (unions of many
/// parts) come to on them: one enclosure tells the sign of the function on a piece and which choices are
/// decided there, and so the shorter tape that holds along all lines of the bundle (docs/evaluation.md). The
/// culling of SlabSearch.
class ChoicePieces {
  public:
    /// Ranges of depth that all lines together are cut into.
    static constexpr std::size_t slabs = 8;

    /// `function` is what `forms` evaluates; all three must outlive the pieces.
    ChoicePieces(const PreparedFunction& function, const RootSettings& settings, AffineEvaluator& forms);

    /// What is enclosed and simplified from now on: a tape that holds on all pieces to come, which must
    /// outlive its use, or null for the whole one.
    void setBase(const SimplifiedTape* base);

    /// Puts the range of a bundle into a lane.
    void place(const LineBundle& bundle, const DepthRange& range, std::size_t lane);
    /// Encloses the pieces of the first `count` lanes.
    void enclose(std::size_t count);

    /// In the place of enclose(): nothing is inside in these lanes, and nothing decided.
    void setOutside(std::size_t count) { std::fill_n(signs_.begin(), count, 1.0); }

    /// The certain sign of the function all over an enclosed piece, negative inside; 0 where there is none.
    double sign(std::size_t lane) const { return signs_[lane]; }
    /// Whether most choices are decided on the first `count` lanes, all of them enclosed.
    bool mostDecided(std::size_t count) const;
    /// The tape that holds on all of these enclosed pieces.
    void simplify(std::uint64_t lanes, SimplifiedTape& simplifiedTape);

  private:
    const RootSettings& settings_;
    AffineEvaluator& forms_;
    TapeSimplifier simplifier_;
    const std::vector<SignLevel> levels_;
    std::size_t choiceCount_;  ///< of the whole tape
    const SimplifiedTape* base_ = nullptr;
    RayPieces pieces_;
    RaySpread spread_;
    std::vector<LaneChoices> choices_;
    std::array<double, batchLanes> signs_{};
};

}  // namespace isoscope
