// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "core/evaluate/affine_evaluator.h"

namespace isoscope {

/// What a step of a lane has come to that is not plain marching; GeneralSearch deals with it.
enum class MarchEvent : std::int32_t {
    none,
    reachedEnd,  ///< the rest of the line holds no root; start = far
    crossing,    ///< a certain change of sign between low and high, at most `tolerance` apart
    bracket,     ///< of MarchKernel: the same further apart, but in a small part of the piece
    jump,        ///< of CaseMarch: the same where the function jumps, at most 1/64 resolution apart
    newSign,  ///< the sign at the start is certain, and it is not the last one, or is the first and `watched`
    unresolved,  ///< the piece is too short to be cut further; nothing is known about it
    undefined,   ///< the function has no value on the piece
    exhausted,   ///< the budget is spent
};

/// How far searches for roots have come, side by side: entry i of each array is lane i. The piece at hand is
/// in RayPieces (start, length).
struct MarchLanes {
    using Lanes = std::array<double, batchLanes>;

    // For `watched`.
    static constexpr double noSign = -1, insideSign = 0, anySign = 2;

    Lanes far;              ///< end of the line
    Lanes resolution;       ///< pieces are not made shorter
    Lanes tolerance;        ///< how narrow a crossing has to be; at least the resolution
    Lanes sign;             ///< last certain sign (1, -1), 0 when there is none
    Lanes signPlace;        ///< up to here it is certain
    Lanes watched;          ///< the first certain sign is an event too if it is less than this
    Lanes unresolvedError;  ///< error of the last piece that could not be cut further, else 0
    Lanes evaluations;
    Lanes budget;
    Lanes jump;     ///< where the function jumps in a piece that is passed over; far where that is not known
    Lanes resumed;  ///< how long the piece may be behind one that is passed over; 0 where nothing is known

    // Of the last step, where it ended in an event.
    Lanes low, high;     ///< of a crossing or a jump
    Lanes slope, error;  ///< of the form; the slope relative to `sign`
    Lanes newSign;       ///< of the event newSign

    /// Makes lane `to` what lane `from` is, between steps.
    void copyLane(std::size_t from, std::size_t to) {
        for (Lanes* lanes : kept()) (*lanes)[to] = (*lanes)[from];
    }
    /// Exchanges what two lanes keep between steps; the pieces are the caller's to exchange.
    void swapLanes(std::size_t a, std::size_t b) {
        for (Lanes* lanes : kept()) std::swap((*lanes)[a], (*lanes)[b]);
    }

  private:
    std::array<Lanes*, 11> kept() {
        return {&far,         &resolution, &tolerance, &sign,   &signPlace, &watched, &unresolvedError,
                &evaluations, &budget,     &jump,      &resumed};
    }
};

/// How values of a function become signs: negative inside.
struct SignRule {
    double threshold = 0;
    bool positivePolarity = false;
};

/// One step of the first `count` lanes, given the enclosures of the function on their pieces: each moves on
/// by what is certainly free of roots, or shortens its piece (docs/evaluation.md), or answers with an
/// event. A lane with an event other than reachedEnd or exhausted keeps its piece, but for pieces shorter
/// than the resolution: these become as long as that, unless the event is crossing or undefined. events has
/// room for batchLanes entries. Returns whether any lane has an event.
bool march(RayPieces& pieces, MarchLanes& lanes, const AffineLanes& forms, const SignRule& rule,
           std::size_t count, MarchEvent* events);

}  // namespace isoscope
