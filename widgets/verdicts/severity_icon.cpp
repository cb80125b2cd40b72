// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/verdicts/severity_icon.h"

#include <QPainter>

namespace isoscope {

namespace {

QColor colorOf(Severity severity) {
    switch (severity) {
        case Severity::error: return {0xd3, 0x3a, 0x3a};
        case Severity::warning: return {0xe0, 0x9a, 0x1e};
        case Severity::leftOut: return {0x6f, 0x86, 0xa6};
        case Severity::note: return {0x2f, 0x7f, 0xd8};
    }
    return {};
}

/// In a square of 16.
void paintSign(QPainter& painter, Severity severity) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colorOf(severity));
    const QPen white(Qt::white, 1.8, Qt::SolidLine, Qt::RoundCap);
    const QPen black(QColor(0x20, 0x18, 0x00), 1.8, Qt::SolidLine, Qt::RoundCap);
    switch (severity) {
        case Severity::error:
            painter.drawEllipse(QRectF(1, 1, 14, 14));
            painter.setPen(white);
            painter.drawLine(QPointF(5.5, 5.5), QPointF(10.5, 10.5));
            painter.drawLine(QPointF(10.5, 5.5), QPointF(5.5, 10.5));
            break;
        case Severity::warning:
            painter.drawPolygon(QPolygonF{{{8, 1}, {15.5, 14.5}, {0.5, 14.5}}});
            painter.setPen(black);
            painter.drawLine(QPointF(8, 6), QPointF(8, 9.5));
            painter.drawPoint(QPointF(8, 12.3));
            break;
        case Severity::leftOut:
            painter.drawRoundedRect(QRectF(1.5, 1.5, 13, 13), 2, 2);
            painter.setPen(white);
            painter.drawLine(QPointF(5, 8), QPointF(11, 8));
            break;
        case Severity::note:
            painter.drawEllipse(QRectF(1, 1, 14, 14));
            painter.setPen(white);
            painter.drawLine(QPointF(8, 7.5), QPointF(8, 11.5));
            painter.drawPoint(QPointF(8, 4.6));
            break;
    }
}

}  // namespace

QIcon severityIcon(Severity severity) {
    QIcon icon;
    for (const int size : {16, 32, 48}) {
        QPixmap pixmap(size, size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.scale(size / 16.0, size / 16.0);
        paintSign(painter, severity);
        icon.addPixmap(pixmap);
    }
    return icon;
}

}  // namespace isoscope
