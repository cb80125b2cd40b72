// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/chart_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "widgets/numbers/number_text.h"
#include "widgets/section/section_field.h"

namespace isoscope {

namespace {

/// 1, 2 or 5 times a power of ten that is nearest below (or above) a positive value, up to rounding.
double roundFactor(double value, bool above) {
    const double power = std::pow(10.0, std::floor(std::log10(value) + 1e-9));
    const double digit = value / power;
    constexpr double slack = 1e-6;
    for (const double step : above ? std::vector<double>{1, 2, 5, 10} : std::vector<double>{5, 2, 1})
        if (above ? digit <= step * (1 + slack) : digit >= step * (1 - slack)) return step * power;
    return value;
}

QString decadeText(int exponent) {
    // As numbers are typed in a scene.
    return exponent >= -3 && exponent <= 4 ? numberText(std::pow(10.0, exponent))
                                           : QStringLiteral("1e%1").arg(exponent);
}

std::vector<ChartTick> logarithmicTicks(const ChartAxis& axis, int most) {
    std::vector<ChartTick> ticks;
    if (axis.zero > 0) ticks.push_back({std::log10(axis.zero), QStringLiteral("0")});
    const double from = axis.placeLow(), to = axis.placeHigh();
    const double labelled = axis.zero > 0 ? std::log10(axis.zero) + 0.5 : from - 1e-9;
    const int first = static_cast<int>(std::ceil(from - 1e-9)),
              last = static_cast<int>(std::floor(to + 1e-9));
    const int decades = last - first + 1;
    const int step = std::max(1, (decades + most - 1) / std::max(1, most));
    for (int k = first; k <= last; ++k)
        if (k >= labelled && (k - last) % step == 0) ticks.push_back({static_cast<double>(k), decadeText(k)});
    if (decades * 2 > most) return ticks;
    for (int k = first - 1; k <= last; ++k)
        for (const int digit : {2, 5}) {
            const double place = k + std::log10(digit);
            if (place >= std::max(labelled, from - 1e-9) && place <= to + 1e-9)
                ticks.push_back(
                    {place, numberText(roundToResolution(digit * std::pow(10.0, k), std::pow(10.0, k)))});
        }
    return ticks;
}

}  // namespace

double ChartAxis::place(double value) const {
    if (!logarithmic) return value;
    if (value == 0 && zero > 0) return std::log10(zero);
    return value > 0 ? std::log10(value) : std::numeric_limits<double>::quiet_NaN();
}

double ChartAxis::value(double place) const { return logarithmic ? std::pow(10.0, place) : place; }

bool ChartAxis::usable() const {
    return std::isfinite(placeLow()) && std::isfinite(placeHigh()) && placeLow() < placeHigh();
}

std::vector<ChartTick> chartTicks(const ChartAxis& axis, int most) {
    if (!axis.usable()) return {};
    if (axis.logarithmic) return logarithmicTicks(axis, most);
    const double step = roundedUp((axis.high - axis.low) / std::max(1, most));
    std::vector<ChartTick> ticks;
    for (int i = 0; i <= 2 * most; ++i) {
        const double value = (std::ceil(axis.low / step - 1e-9) + i) * step;
        if (value > axis.high + step * 1e-6) break;
        ticks.push_back({value, QString::number(std::abs(value) < step / 2 ? 0 : value, 'g', 5)});
    }
    return ticks;
}

ChartAxis axisOver(const QString& title, const std::vector<double>& values, bool logarithmic) {
    ChartAxis axis{title, 0, 1, logarithmic, 0};
    double low = std::numeric_limits<double>::infinity(), high = -low;
    bool anyZero = false;
    for (const double value : values) {
        if (!std::isfinite(value) || (logarithmic && value < 0)) continue;
        if (logarithmic && value == 0) {
            anyZero = true;
            continue;
        }
        low = std::min(low, value);
        high = std::max(high, value);
    }
    if (!(low <= high)) low = high = 1;
    if (logarithmic) {
        axis.low = roundFactor(low, false);
        axis.high = roundFactor(high, true);
        // A chart of hardly any spread would blow up noise.
        if (axis.high < axis.low * 9) {
            axis.low = std::pow(10.0, std::floor(std::log10(low) + 1e-9));
            axis.high = std::max(axis.high, axis.low * 10);
        }
        if (anyZero) axis.low = axis.zero = std::pow(10.0, std::floor(std::log10(axis.low) + 1e-9) - 1);
    } else {
        const double margin = high > low ? 0.05 * (high - low) : std::max(1e-12, 0.5 * std::abs(high));
        axis.low = low - margin;
        axis.high = high + margin;
    }
    return axis;
}

}  // namespace isoscope
