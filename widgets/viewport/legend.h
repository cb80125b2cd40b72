// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QList>
#include <QString>

class QPainter;
class QRect;

namespace isoscope {

/// What one colour of an overlay means. An invalid colour stands for what is left unmarked.
struct LegendEntry {
    QColor color;
    QString text;
};

/// Draws the entries on a dark ground into the lower left corner of `area`; returns the part of the area
/// above it.
QRect paintLegend(QPainter& painter, const QRect& area, const QList<LegendEntry>& entries);

}  // namespace isoscope
