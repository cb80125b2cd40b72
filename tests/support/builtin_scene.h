// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/function/builtins/builtin.h"

namespace isoscope::test {

/// An isosurface statement that shows a built-in of points with its defaults, in the container of its table;
/// `items` stand behind the others.
inline std::string builtinStatement(const Builtin& builtin, const std::string& items = {}) {
    // "sphere 0 1.1" is "sphere { 0 1.1 }": commas between vectors are optional.
    const std::size_t blank = builtin.container.find(' ');
    std::string call = sampleCall(builtin);
    if (builtin.invert) call = "-(" + call + ")";
    return "isosurface { function { " + call + " } threshold " + std::to_string(builtin.threshold) +
           " contained_by { " + builtin.container.substr(0, blank) + " { " + builtin.container.substr(blank) +
           " } } " + items + " }\n";
}

}  // namespace isoscope::test
