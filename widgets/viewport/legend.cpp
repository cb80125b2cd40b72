// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/legend.h"

#include <algorithm>
#include <QPainter>

namespace isoscope {

QRect paintLegend(QPainter& painter, const QRect& area, const QList<LegendEntry>& entries) {
    constexpr int margin = 10, padding = 8, swatch = 12;
    if (entries.isEmpty()) return area;
    const QFontMetrics metrics = painter.fontMetrics();
    const int line = metrics.height() + 3;
    int textWidth = 0;
    for (const LegendEntry& entry : entries)
        // The bounds can be wider than the advance, and would then be elided.
        textWidth = std::max(textWidth, metrics.horizontalAdvance(entry.text) + swatch / 2);
    textWidth = std::min(textWidth, area.width() - 2 * margin - swatch - 3 * padding);
    const int height = line * static_cast<int>(entries.size()) + 2 * padding;
    const QRect box(area.left() + margin, area.bottom() - margin - height, textWidth + swatch + 3 * padding,
                    height);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0x2b, 0x2e, 0x33, 225));
    painter.drawRoundedRect(box, 5, 5);
    int top = box.top() + padding;
    for (const LegendEntry& entry : entries) {
        const QRect square(box.left() + padding, top + (line - swatch) / 2, swatch, swatch);
        QColor color = entry.color;
        color.setAlpha(255);
        painter.setPen(QColor(0xd0, 0xd0, 0xd0));
        painter.setBrush(entry.color.isValid() ? QBrush(color) : Qt::NoBrush);
        painter.drawRect(square);
        painter.setPen(Qt::white);
        painter.drawText(QRect(square.right() + padding, top, textWidth, line),
                         Qt::AlignLeft | Qt::AlignVCenter,
                         metrics.elidedText(entry.text, Qt::ElideRight, textWidth));
        top += line;
    }
    return area.adjusted(0, 0, 0, box.top() - area.bottom());
}

}  // namespace isoscope
