// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/number_format.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include <locale.h>

namespace isoscope {

namespace {

template <class... Format>
std::string format(double value, Format... how) {
    if (std::isnan(value)) return "nan";  // the sign of a NaN means nothing
    std::array<char, 1024> buffer;        // the largest double has 309 digits before its point
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, how...).ptr;
    return {buffer.data(), end};
}

}  // namespace

std::string exactNumber(double value) { return format(value, std::chars_format::general, 17); }

std::string fixedNumber(double value, int decimals) {
    return format(value, std::chars_format::fixed, decimals);
}

std::string generalNumber(double value, int digits) {
    return format(value, std::chars_format::general, digits);
}

double leadingNumber(const char* text, char** end) {
    static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
    return strtod_l(text, end, plain);
}

std::string shortestNumber(double value) { return format(value); }

}  // namespace isoscope
