// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/evaluate/tape/tape.h"

namespace isoscope {

/// The square roots, by their instructions, that result 0 depends on other than through another one; none
/// unless one of them counts in more than one way, as the distances of a smooth minimum do.
std::vector<std::size_t> sharedRoots(const Tape& tape);

}  // namespace isoscope
