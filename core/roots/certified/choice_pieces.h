// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/evaluate/affine_evaluator.h"
#include "core/evaluate/tape/tape_simplifier.h"
#include "core/roots/certified/line_bundle.h"
#include "core/roots/root_settings.h"

namespace isoscope {

class PreparedFunction;

/// A piece of the depth along a bundle of lines.
struct DepthRange {
    double near = 0, far = -1;

    /// Number `k` of `count` equal parts; adjacent ones meet exactly.
    DepthRange part(std::size_t k, std::size_t count) const {
        return {border(k, count), border(k + 1, count)};
    }
    /// Where part `k` of `count` begins; border(count, count) is `far` to the last bit.
    double border(std::size_t k, std::size_t count) const {
        if (k == count) return far;
        return near + (far - near) * static_cast<double>(k) / static_cast<double>(count);
    }
};

/// Pieces of bundles, up to batchLanes side by side, with what functions full of choices (unions of many
/// parts) come to on them: one enclosure tells the sign of the function on a piece and which choices are
/// decided there, and so the shorter tape that holds along all lines of the bundle (docs/evaluation.md). The
/// culling that CellMarch and SlabSearch share.
class ChoicePieces {
  public:
    /// Ranges of depth that all lines together are cut into.
    static constexpr std::size_t slabs = 8;
    /// Tapes with fewer choices are not worth it.
    static constexpr std::size_t fewestChoices = 8;

    /// `function` is what `forms` evaluates; all three must outlive the pieces.
    ChoicePieces(const PreparedFunction& function, const RootSettings& settings, AffineEvaluator& forms);

    /// Whether the tape can become short at all.
    bool worthwhile() const { return worthwhile_; }
    /// Whether tapes that hold so many instructions together are short, in the place of `tapes` whole ones.
    bool areShort(std::size_t instructions, std::size_t tapes) const;

    /// What is enclosed and simplified from now on: a tape that holds on all pieces to come, which must
    /// outlive its use, or null for the whole one.
    void setBase(const SimplifiedTape* base);

    /// Puts the range of a bundle into a lane.
    void place(const LineBundle& bundle, const DepthRange& range, std::size_t lane);
    /// Encloses the pieces of the first `count` lanes.
    void enclose(std::size_t count);

    /// The certain sign of the function all over an enclosed piece, negative inside; 0 where there is none.
    double sign(std::size_t lane) const { return signs_[lane]; }
    /// Whether most choices are decided on the first `count` lanes, all of them enclosed.
    bool mostDecided(std::size_t count) const;
    /// The tape that holds on all of these enclosed pieces.
    void simplify(std::uint64_t lanes, SimplifiedTape& simplifiedTape);

  private:
    const RootSettings& settings_;
    AffineEvaluator& forms_;
    std::size_t tapeLength_;
    TapeSimplifier simplifier_;
    std::size_t choiceCount_;  ///< of the whole tape
    bool worthwhile_;
    const SimplifiedTape* base_ = nullptr;
    RayPieces pieces_;
    RaySpread spread_;
    std::vector<LaneChoices> choices_;
    std::array<double, batchLanes> signs_{};
};

}  // namespace isoscope
