// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace isoscope {

/// The value rounded to a decimal multiple no coarser than `resolution` (> 0): 0.35000000001 with 0.002 is
/// 0.35. Values that are not finite, and resolutions that are not positive, leave the value as it is.
double roundToResolution(double value, double resolution);

/// The shortest decimal text that is `value` to within `resolution`, as the scene language reads it: a point,
/// no trailing zeros, an exponent only where it is much shorter ("1e-6"), never "-0". What is not finite
/// gives "0".
QString numberText(double value, double resolution);

/// The shortest text that reads back as exactly `value`.
QString numberText(double value);

/// The value with so many digits behind the point; as numberText() for -1.
QString numberTextWith(double value, int decimals);

}  // namespace isoscope
