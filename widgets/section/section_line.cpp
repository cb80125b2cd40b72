// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/section/section_line.h"

#include <algorithm>
#include <cmath>
#include <QLineF>
#include <QPainter>

namespace isoscope {

namespace {

constexpr double gripReach = 8;
constexpr double endRadius = 4.5;

QPointF within(const QRectF& limits, const QPointF& p) {
    return {std::clamp(p.x(), limits.left(), limits.right()),
            std::clamp(p.y(), limits.top(), limits.bottom())};
}

double distanceToLine(const QPointF& p, const QLineF& line) {
    const QPointF along = line.p2() - line.p1();
    const double square = QPointF::dotProduct(along, along);
    const double share =
        square > 0 ? std::clamp(QPointF::dotProduct(p - line.p1(), along) / square, 0.0, 1.0) : 0;
    return QLineF(p, line.p1() + share * along).length();
}

}  // namespace

SectionLineTool::Grip SectionLineTool::gripAt(const QPointF& pixel, const Maps& maps) const {
    if (!on_ || !line_) return Grip::none;
    const QLineF shown(maps.toPixel(line_->from), maps.toPixel(line_->to));
    if (QLineF(pixel, shown.p2()).length() <= gripReach) return Grip::to;
    if (QLineF(pixel, shown.p1()).length() <= gripReach) return Grip::from;
    return distanceToLine(pixel, shown) <= gripReach / 2 ? Grip::whole : Grip::none;
}

void SectionLineTool::press(const QPointF& pixel, const Maps& maps) {
    grip_ = gripAt(pixel, maps);
    last_ = maps.toPlane(pixel);
    before_ = line_;
    if (grip_ != Grip::none) return;
    // A new line; it exists once the mouse has moved.
    grip_ = Grip::to;
    last_ = within(maps.limits, last_);
    line_ = SectionLine{last_, last_};
}

bool SectionLineTool::drag(const QPointF& pixel, const Maps& maps) {
    if (!line_ || grip_ == Grip::none) return false;
    const SectionLine before = *line_;
    const QPointF place = maps.toPlane(pixel);
    if (grip_ == Grip::from) line_->from = within(maps.limits, place);
    if (grip_ == Grip::to) line_->to = within(maps.limits, place);
    if (grip_ == Grip::whole) {
        const QPointF by = place - last_;
        if (maps.limits.contains(line_->from + by) && maps.limits.contains(line_->to + by)) {
            line_->from += by;
            line_->to += by;
        }
    }
    last_ = place;
    return !(*line_ == before);
}

void SectionLineTool::release() {
    grip_ = Grip::none;
    if (line_ && line_->from == line_->to) line_ = before_;
}

void SectionLineTool::paint(QPainter& painter, const Maps& maps, std::optional<double> share) const {
    if (!on_ || !line_ || line_->from == line_->to) return;
    const QPointF from = maps.toPixel(line_->from), to = maps.toPixel(line_->to);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    // Seen on every colour of the section.
    for (const QPen& pen : {QPen(QColor(0, 0, 0, 170), 4), QPen(QColor(0xff, 0xe0, 0x60), 1.8)}) {
        painter.setPen(pen);
        painter.drawLine(from, to);
    }
    painter.setPen(QPen(QColor(0, 0, 0, 200), 1.5));
    painter.setBrush(QColor(0xff, 0xe0, 0x60));
    for (const QPointF& end : {from, to}) painter.drawEllipse(end, endRadius, endRadius);
    if (share) {
        painter.setBrush(Qt::white);
        painter.drawEllipse(from + *share * (to - from), endRadius - 1, endRadius - 1);
    }
    QFont small = painter.font();
    small.setBold(true);
    painter.setFont(small);
    // Above the ends, below them at the upper edge.
    for (const auto& [end, text] :
         {std::pair(from, QStringLiteral("A")), std::pair(to, QStringLiteral("B"))}) {
        constexpr double away = 13;
        const QRectF box(end + QPointF(-8, (end.y() < 2 * away ? away : -away) - 8), QSizeF(16, 16));
        painter.setPen(QColor(0, 0, 0, 200));
        painter.drawText(box.translated(1, 1), Qt::AlignCenter, text);
        painter.setPen(QColor(0xff, 0xe0, 0x60));
        painter.drawText(box, Qt::AlignCenter, text);
    }
}

}  // namespace isoscope
