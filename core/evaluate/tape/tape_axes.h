// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/evaluate/tape/tape.h"

namespace isoscope {

/// Which coordinates the instructions of a tape depend on, bit k for coordinate k, when the instructions
/// `left` count for none. Behind those of the last instruction come those of result 0.
std::vector<std::uint8_t> axesWithout(const Tape& tape, std::span<const std::size_t> left = {});

/// Whether the result of an instruction is a sum of its operands times uniform factors.
bool isLinear(const Tape& tape, const Instruction& instruction);

/// Which coordinates the gradient of result 0 depends on, bit k for coordinate k, for certain not the others:
/// y - f(x, z) has the same slopes wherever y is.
std::uint8_t gradientAxes(const Tape& tape);

}  // namespace isoscope
