// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/picture_message.h"

#include <QPainter>

namespace isoscope {

void paintMessage(QPainter& painter, const QRect& area, Qt::Alignment alignment, const QString& text) {
    const int flags = static_cast<int>(alignment) | Qt::TextWordWrap;
    const QRect place = painter.fontMetrics().boundingRect(area.adjusted(24, 12, -24, -12), flags, text);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0x2b, 0x2e, 0x33, 225));
    painter.drawRoundedRect(place.adjusted(-10, -6, 10, 6), 5, 5);
    painter.setPen(Qt::white);
    painter.drawText(place, flags, text);
}

}  // namespace isoscope
