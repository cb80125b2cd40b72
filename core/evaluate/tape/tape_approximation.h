// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/evaluate/tape/tape_simplifier.h"
#include "core/evaluate/tape/uniform_values.h"

namespace isoscope {

class IntervalEvaluator;

/// There are no more than so many of one tape.
constexpr std::size_t mostApproximations = 8;

/// An approximation of a function: without the terms that amount to little wherever the point is, as the high
/// octaves of a fractal sum do, and without choices that are the same everywhere.
struct TapeApproximation {
    std::shared_ptr<const SimplifiedTape> tape;  ///< TapeLinks::whole() itself where nothing is left out
    double offset = 0;                           ///< to be added to the tape's value
    double error = 0;  ///< the function is no further than this from the sum of both
};

/// What is decided wherever the point is, one entry for each choosing instruction of the tape, as
/// TapeSimplifier wants them. `everywhere` has just enclosed the tape for all arguments there may be.
///
/// With `levels` (TapeLinks::levels() for a threshold) they make another function, which is above the
/// threshold where this one is, and below where this one is, in doubles: cases that are all on one side of
/// the threshold are one.
std::vector<Choice> choicesEverywhere(const TapeLinks& links, const IntervalEvaluator& everywhere,
                                      std::span<const SignLevel> levels = {});

/// Approximations of the tape's first result with these choices, in real arithmetic: first one without error,
/// then coarser ones, each a good deal cheaper than the one before. `everywhere` is as for the choices, with
/// these uniform values. At most mostApproximations; none for tapes with loops.
std::vector<TapeApproximation> approximationsOf(const TapeLinks& links, std::span<const Choice> choices,
                                                const IntervalEvaluator& everywhere,
                                                const UniformValues& uniforms);

}  // namespace isoscope
