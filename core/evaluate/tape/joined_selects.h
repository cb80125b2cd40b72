// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/evaluate/tape/tape.h"

namespace isoscope {

/// By instruction of a tape with these values of its uniform slots: whether it is a select whose sides have
/// the same value where its condition is 0, but for roundings, as those of a colour map have at each of its
/// entries. Such a select jumps nowhere that its operands do not. Only conditions that are a value, or a
/// value beside a uniform one, are understood, and sides that are known where that value is. None for tapes
/// of very many instructions.
std::vector<bool> joinedSelects(const Tape& tape, std::span<const double> uniforms);

}  // namespace isoscope
