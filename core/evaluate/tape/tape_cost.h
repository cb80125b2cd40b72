// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluate/tape/tape.h"

namespace isoscope {

/// About what an enclosure of a function costs, for searches that choose how to go about it.
struct TapeCost {
    /// Whether the function holds noise, which costs several times what following a bundle of lines does.
    bool holdsNoise = false;
    /// Whether an enclosure costs less than to look after a line.
    bool cheap = false;
    /// Whether it has many instructions, or loops.
    bool isLong = false;

    TapeCost() = default;
    explicit TapeCost(const Tape& tape);
};

}  // namespace isoscope
