// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QImage>
#include <QList>
#include <QPalette>
#include <QSize>
#include <QString>

#include "widgets/charts/chart.h"

namespace isoscope {

/// Charts side by side, as a file is to show them.
struct ChartSheet {
    QList<Chart> charts;
    QSize chartSize{640, 420};  ///< of each
    QPalette palette;
    QFont font;
};

/// Writes an SVG, or a PNG of twice the size, by the suffix of `path`. False when the file cannot be written,
/// when there is no chart, and for other suffixes.
bool saveCharts(const ChartSheet& sheet, const QString& path);

/// The points of a chart as comma separated values: series, x, y.
QString chartTable(const Chart& chart);

/// Writes a PNG, or text, to a file in one go; false when that fails, and what was there stays.
bool savePicture(const QImage& picture, const QString& path);
bool saveText(const QString& text, const QString& path);

}  // namespace isoscope
