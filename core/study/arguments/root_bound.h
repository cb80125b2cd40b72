// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>

#include "core/study/gradient/gradient_domain.h"

namespace isoscope {

class PreparedFunction;

/// What boundByRoots() says.
struct RootBound {
    /// No gradient in the domain is longer; infinite where nothing is known.
    double bound = std::numeric_limits<double>::infinity();
    std::uint64_t boxes = 0;  ///< that were evaluated
};

/// A bound for functions of few distances, such as smooth minima: where f(x, y, z) = g(r, s, ...) and r and s
/// are square roots of known steepness (sharedRoots()), or coordinates, three together at most, |grad f| is
/// no larger than |dg/dr| |grad r| + |dg/ds| |grad s| + ... Branch and bound over r, s, ... as if they were
/// independent, until the sum is at most `target` everywhere, or boxes run out. As good as it can be where
/// that sum is the same everywhere; a blend of distances has 1. A LoopStop ends it within milliseconds.
RootBound boundByRoots(const PreparedFunction& function, const GradientDomain& domain, double target);

}  // namespace isoscope
