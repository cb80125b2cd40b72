// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// A formula as mathematicians and graphing calculators write it.
struct BareFormula {
    std::size_t end = 0;             ///< the byte behind it
    std::string function;            ///< in POV-Ray's words: 0 where the equation holds
    std::vector<std::string> names;  ///< the declared numbers that it uses
};

/// The formula that begins at byte `begin` of `text` and ends with its line, or in a later one where an
/// operator or an open parenthesis goes on; empty where none begins. It has an x, y or z and more than that.
///
/// Understood are equations and inequalities (what is smaller is inside), `^` and `**` (the right one first,
/// before a sign), superscripts, products without a sign (`2x`, `3(x+1)`, `xy`), |x|, the functions of
/// POV-Ray with `log10`, `arcsin`, `sec`, `cbrt` and the like, pi, tau, e, and names that `isNumber` knows.
std::optional<BareFormula> readBareFormula(std::string_view text, std::size_t begin,
                                           const std::function<bool(std::string_view)>& isNumber);

}  // namespace isoscope
