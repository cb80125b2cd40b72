// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace isoscope {

/// What is certain about the answer for one line.
enum class Verdict : std::uint8_t {
    certifiedHit,    ///< nothing between the start and the first root
    certifiedMiss,   ///< no root at all
    gap,             ///< the same, except for unresolved places narrower than a hundredth of the accuracy
    budgetExceeded,  ///< the evaluations ran out; the rest was sampled, or searched as POV-Ray does
    notCertified,    ///< the function holds an operation without proven bounds
};

/// The word for a verdict in the output of `trace`, e.g. "certified-hit": static text.
const char* name(Verdict verdict);

}  // namespace isoscope
