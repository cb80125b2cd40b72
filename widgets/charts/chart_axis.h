// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

namespace isoscope {

/// One axis of a chart. A logarithmic axis shows decimal logarithms of positive values; `zero`, where it is
/// set, is the place that stands for 0 there.
struct ChartAxis {
    QString title;
    double low = 0;
    double high = 1;
    bool logarithmic = false;
    double zero = 0;

    /// Where a value lies: the value or its logarithm. NaN for what a logarithmic axis cannot show.
    double place(double value) const;
    double value(double place) const;
    double placeLow() const { return place(low); }
    double placeHigh() const { return place(high); }

    /// Whether the ends make an axis.
    bool usable() const;
};

/// A tick of an axis: its place, as ChartAxis::place() has it, and the text beside it.
struct ChartTick {
    double place;
    QString label;
};

/// Round places with labels, at most about `most`.
std::vector<ChartTick> chartTicks(const ChartAxis& axis, int most);

/// An axis over all finite values: logarithmic ones from power to power of ten (or to 2 and 5 times one where
/// that is much wider), with a place for 0 where a value is 0; linear ones with a margin. Never empty.
ChartAxis axisOver(const QString& title, const std::vector<double>& values, bool logarithmic);

}  // namespace isoscope
