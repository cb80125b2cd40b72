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

}  // namespace isoscope
