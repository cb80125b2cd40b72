// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace isoscope {

/// 17 significant digits, enough to read the same double back; `nan`, `inf`, `-inf`. Independent of the
/// locale.
std::string exactNumber(double value);

/// The shortest decimal that reads back as the same double; independent of the locale.
std::string shortestNumber(double value);

/// The number with `decimals` digits behind the point; independent of the locale.
std::string fixedNumber(double value, int decimals);

}  // namespace isoscope
