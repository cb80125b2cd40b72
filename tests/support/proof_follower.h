// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <span>

#include "core/roots/certified/proof_recorder.h"
#include "core/roots/verdict.h"
#include "tests/support/exact_line.h"

namespace isoscope::test {

/// What a certified root finder says of a line, and the steps by which it has come to that.
struct ClaimedLine {
    LineQuery line;
    RootSettings settings;
    std::span<const ProofStep> steps;
    std::span<const Root> roots;
    Verdict verdict = Verdict::gap;
};

/// How many steps were followed.
struct FollowedSteps {
    std::uint64_t confirmed = 0;
    std::uint64_t open =
        0;  ///< neither confirmed nor refuted: values that doubles cannot hold, or the pieces ran out
};

/// Follows the steps of a line from its beginning: that there is no hole between them, that each form has the
/// sign that is claimed, holds the function at some points, and that the function has the sign all over the
/// part, by enclosures of its own; that it has the signs that are claimed on both sides of roots; and that
/// the steps are enough for the verdict. Empty if all that is so, else what is not.
QString followProof(const ClaimedLine& claimed, ExactLine& line, FollowedSteps& counts);

}  // namespace isoscope::test
