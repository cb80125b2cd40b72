// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluate/tape/tape.h"

namespace isoscope {

/// Whether two tapes run the same instructions over the same slots, those of their loops included. Where the
/// values of their uniform slots are the same, too (UniformValues::sameAs), they compute the same.
bool sameCode(const Tape& a, const Tape& b);

}  // namespace isoscope
