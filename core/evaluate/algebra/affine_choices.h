// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/evaluate/algebra/affine_form.h"
#include "core/evaluate/tape/tape_simplifier.h"

namespace isoscope {

/// An operand of up to batchLanes lanes: centers, slopes and errors, batchLanes of each; without lanes, the
/// same form in all.
struct AffineOperand {
    const double* lanes = nullptr;
    AffineForm uniform;
};

/// Which of two forms is the lower one all along (the higher one unless `takesLower`), in the first `count`
/// lanes; open where that is not certain. With `level`, only the sign of what is taken minus *level
/// counts: an operand that is certain to leave that to the other one is not taken.
LaneChoices decideAffineChoices(const AffineOperand& first, const AffineOperand& second, bool takesLower,
                                const SignLevel* level, std::size_t count);

/// The lanes (a bit for each) in which a form is certain to be above a level all along, and those in which
/// it is certain to be below.
struct LanesBeyond {
    std::uint64_t above = 0, below = 0;
};
/// Those of the first `count` lanes.
LanesBeyond lanesBeyond(const AffineOperand& form, const SignLevel& level, std::size_t count);

}  // namespace isoscope
