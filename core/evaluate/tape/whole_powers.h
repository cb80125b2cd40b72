// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/evaluate/tape/tape_sources.h"

namespace isoscope {

/// A whole power of one operand, made of squares and products: x^6 of x*x*x and the like.
struct WholePower {
    TapeSource base = 0;
    double exponent = 0;  ///< 3 or more; 0 for what is none
};

/// What each instruction of a tape is.
std::vector<WholePower> wholePowers(const Tape& tape);

}  // namespace isoscope
