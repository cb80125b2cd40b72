// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/function/function_graph.h"

namespace isoscope {

/// A part of a function body that has been read.
struct FunctionOperand {
    NodeId node = noNode;
    /// Written as a number, as a declared float, or combined from such while parsing
    /// (docs/povray/operators.md, section 2); `value` is then its value. Anything in parentheses is no
    /// constant in this sense.
    bool constant = false;
    double value = 0;
    /// One number of the text with at most one sign: what a slider can move.
    bool literal = false;
};

}  // namespace isoscope
