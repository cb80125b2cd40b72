// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "core/shapes/isosurface/isosurface.h"

namespace isoscope {

/// A function with its derivatives in POV-Ray's language.
struct DerivativeText {
    /// `#declare`s of functions of x, y, z: NAME itself, NAME_dx, NAME_dy, NAME_dz, NAME_gradient (the length
    /// of the gradient) and NAME_normalised: (f - threshold) / |gradient|, whose gradient has the length 1 on
    /// the surface f = threshold, wherever the gradient is not 0 there. What they have in common is declared
    /// in front of them. Empty where there is none.
    std::string declarations;
    std::string problem;  ///< why not, a sentence
    /// The normalised function as Isoscope knows it, for measuring; not valid() without declarations.
    Function normalised;
};

/// `name` begins all names; it must be a name of the language.
DerivativeText derivativeText(const Isosurface& surface, std::span<const double> parameters,
                              const std::string& name = "f");

}  // namespace isoscope
