// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/expressions/slider_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace isoscope {

namespace {

/// At least four times the value, with one digit or half of one, so that the end of the slider reads well.
double roundReach(double value) {
    constexpr double smallest = 1e-12;  // sliders below would only show rounding
    constexpr double largest = 1e306;
    const double wanted = 4 * std::abs(value);
    if (!(wanted >= smallest)) return 1;
    if (!(wanted <= largest)) return std::numeric_limits<double>::max();
    const int decade = static_cast<int>(std::floor(std::log10(wanted)));
    // Powers with positive exponents are exact, their reciprocals are not.
    const double power = std::pow(10.0, std::abs(decade));
    for (const double digits : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0}) {
        const double reach = decade < 0 ? digits / power : digits * power;
        if (reach >= wanted * (1 - 1e-12)) return reach;
    }
    return decade < 0 ? 10 / power : 10 * power;
}

}  // namespace

SliderRange sliderRangeAround(double value) {
    if (value == 0 || std::isnan(value)) return {-1, 1};
    const double reach = roundReach(value);
    return value > 0 ? SliderRange{0, reach} : SliderRange{-reach, 0};
}

SliderRange symmetricRangeAround(double value) {
    const double reach = roundReach(value);
    return {-reach, reach};
}

}  // namespace isoscope
