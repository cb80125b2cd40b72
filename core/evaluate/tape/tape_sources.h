// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/evaluate/tape/tape.h"

namespace isoscope {

/// What an operand of a tape is, however often its slot is used again: the slot of an argument or of a
/// uniform value, or slotCount() and the number of the instruction whose result it is.
using TapeSource = std::size_t;

/// The sources of the operands of each instruction.
std::vector<std::array<TapeSource, 4>> operandSources(const Tape& tape);

}  // namespace isoscope
