// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>
#include <string>

#include "core/language/functions/bare_formula.h"
#include "core/language/tokens/symbol_table.h"
#include "core/shapes/rays/container.h"

namespace isoscope {

/// An isosurface statement for a formula, with what it takes to see it.
struct FormulaIsosurface {
    std::string statement;  ///< several lines, with a newline at the end; empty for a formula without a value
    std::string scene;      ///< the same with camera, lights and background around it
    Container container;
    bool bounded = false;    ///< the whole surface lies in the container
    double maxGradient = 1;  ///< not less than any gradient in the container, where that could be proven
};

/// Looks for the surface within 10 units around the origin: the container is the smallest round box that
/// certainly holds it, or one through which a part goes on. `symbols` has the values of the formula's names.
/// Takes up to about a second; stops early when asked, with a wider container and gradient.
FormulaIsosurface formulaIsosurface(const BareFormula& formula, const SymbolTable& symbols,
                                    std::stop_token stop = {});

}  // namespace isoscope
