// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace isoscope {

/// Where a slider may go at first.
struct SliderRange {
    double minimum;
    double maximum;
};

/// From zero to a round number of about four times the value: 0 to 0.06 for 0.015, -8 to 0 for -2. -1 to 1
/// for zero and what is no number.
SliderRange sliderRangeAround(double value);

/// The same to both sides of zero, for numbers whose sign often changes.
SliderRange symmetricRangeAround(double value);

}  // namespace isoscope
