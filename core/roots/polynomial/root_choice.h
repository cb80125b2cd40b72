// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/roots/polynomial/real_roots.h"

namespace isoscope {

/// Which root finder a scene asks for, for polynomials along rays.
enum class RootChoice {
    /// realRoots(): every sign change of the exact polynomial is found. That is what `sturm` promises in
    /// POV-Ray's language and SturmSolver in VirtuaLight's, so that both mean this; the sequences themselves
    /// (polynomialRoots) find the same roots in some hundred times the time.
    isolation,
    /// The closed form up to degree 4, isolation above. Roots that nearly touch may be missed.
    ferrari,
    /// The closed form of Ferrari, whose resolvent is solved by Vieta's formula here: the two do not differ.
    vieta,
};

/// The real roots as the scene wants them found; otherwise as realRoots().
void chosenRoots(RootChoice choice, std::span<const double> coefficients, double low, double high,
                 RootSequence& roots);

}  // namespace isoscope
