// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/function/function_graph.h"

namespace isoscope {

/// A function with its partial derivatives, as formulas in one graph.
struct GradientFunction {
    /// Results: the function itself, and its derivatives in its first three arguments. Not valid() where an
    /// operation has no formula, or the graph becomes too large.
    Function function;
    std::optional<Operation> missing;  ///< the operation without one: noise, crackle, loops
};

/// Differentiates the first result of a function. At places without a derivative the formulas give that of a
/// side: abs at 0 that of its operand, min and max at ties that of the operand whose value is taken, jumps
/// (floor, comparisons, div) 0.
GradientFunction gradientOf(const Function& function);

}  // namespace isoscope
