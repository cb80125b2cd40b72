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

/// The number with `digits` significant ones at most, with an exponent where that is shorter, as printf's
/// `%g` has it; independent of the locale.
std::string generalNumber(double value, int digits);

/// The number at the beginning of the text, as strtod reads it, and where it ends; independent of the
/// locale, which Qt takes from the system, so that strtod itself stops at the point of 1.5 in German.
double leadingNumber(const char* text, char** end);

}  // namespace isoscope
