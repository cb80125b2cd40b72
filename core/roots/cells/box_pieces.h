// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "core/evaluate/box_evaluator.h"
#include "core/evaluate/tape/tape_simplifier.h"
#include "core/roots/root_settings.h"

namespace isoscope {

class PreparedFunction;

/// Boxes of space, up to batchLanes side by side, with what a function full of choices (a union of many
/// parts) comes to in them: one enclosure tells the sign of the function in a box and which choices are
/// decided there, and so the shorter tape that holds all over it.
class BoxPieces {
  public:
    /// Both must outlive the boxes.
    BoxPieces(const PreparedFunction& function, const RootSettings& settings);

    /// What is enclosed and simplified from now on: a tape that holds in all boxes to come, which must
    /// outlive its use.
    void setBase(const SimplifiedTape& base);

    /// Puts a box into a lane, and a little more, for the roundings of what is in it.
    void place(const glm::dvec3& center, const glm::dvec3& halfWidth, std::size_t lane);
    /// Encloses the boxes of the first `count` lanes, at least one.
    void enclose(std::size_t count);

    /// The certain sign of the function all over an enclosed box, negative inside; 0 where there is none.
    double sign(std::size_t lane) const { return signs_[lane]; }
    /// Whether certainly no point of an enclosed box is inside: each has a value outside, or none.
    bool isOutside(std::size_t lane) const { return isOutside_[lane]; }
    /// What is decided in the enclosed boxes, choice by choice of the base.
    const std::vector<LaneChoices>& choices() const { return choices_; }
    /// The tape that holds in all of these enclosed boxes (a bit for each).
    void simplify(std::uint64_t lanes, SimplifiedTape& simplifiedTape) {
        simplifier_.simplify(choices_, lanes, 0, simplifiedTape);
        countSimplified(simplifiedTape);
    }
    /// What is left of the function by choices of its whole tape.
    void simplify(const DecidedChoices& choices, SimplifiedTape& simplifiedTape) {
        simplifier_.simplify(choices, simplifiedTape);
        countSimplified(simplifiedTape);
    }

    /// Boxes enclosed so far.
    std::uint64_t evaluations() const { return boxes_.evaluations(); }
    /// What has been done so far, as so many instructions for one box.
    std::uint64_t work() const { return work_; }

  private:
    /// To make one costs about as much as its enclosure in so many boxes.
    void countSimplified(const SimplifiedTape& tape) {
        constexpr std::size_t boxes = 16;
        work_ += boxes * tape.instructions.size();
    }

    const RootSettings& settings_;
    BoxEvaluator boxes_;
    TapeSimplifier simplifier_;
    const std::vector<SignLevel> levels_;
    const SimplifiedTape* base_;
    std::uint64_t work_ = 0;
    BoxLanes lanes_;
    std::vector<LaneChoices> choices_;
    std::array<double, batchLanes> signs_{};
    std::array<bool, batchLanes> isOutside_{};
};

}  // namespace isoscope
