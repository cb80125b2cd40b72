// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluate/tape/tape.h"

namespace isoscope {

/// Whether the function holds noise, which costs several times what following a bundle of lines does.
bool holdsNoise(const Tape& tape);

/// Whether an enclosure costs less than to look after a line.
bool isCheap(const Tape& tape);

}  // namespace isoscope
