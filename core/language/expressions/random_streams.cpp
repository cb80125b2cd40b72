// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/expressions/random_streams.h"

#include <cmath>

namespace isoscope {

double RandomStreams::seed(double value) {
    const double whole = std::trunc(value);
    const bool fits = whole >= -2147483648.0 && whole <= 2147483647.0;
    states_.push_back(static_cast<std::uint32_t>(fits ? static_cast<std::int32_t>(whole) : INT32_MIN));
    return static_cast<double>(states_.size() - 1);
}

std::optional<double> RandomStreams::next(double stream) {
    const double index = std::trunc(stream);
    if (!(index >= 0 && index < static_cast<double>(states_.size()))) return std::nullopt;
    std::uint32_t& state = states_[static_cast<std::size_t>(index)];
    state = state * 1812433253u + 12345u;
    return state / 4294967295.0;
}

}  // namespace isoscope
