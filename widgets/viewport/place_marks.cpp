// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/place_marks.h"

#include <algorithm>
#include <cmath>
#include <QPainter>

namespace isoscope {

namespace {

constexpr double ring = 6;
constexpr double clickReach = 9;
/// More labels than this would hide the picture.
constexpr std::size_t labelLimit = 6;

}  // namespace

void PlaceMarks::set(std::vector<PlaceMark> marks) {
    const auto same = [](const PlaceMark& a, const PlaceMark& b) {
        return a.place == b.place && a.reach == b.reach && a.label == b.label && a.color == b.color;
    };
    if (std::ranges::equal(marks, marks_, same)) return;
    marks_ = std::move(marks);
    emit changed();
}

std::optional<std::size_t> PlaceMarks::markAt(const QPointF& pixel, const ViewProjection& view) const {
    std::optional<std::size_t> nearest;
    double least = clickReach;
    for (std::size_t i = 0; i < marks_.size(); ++i) {
        const auto at = view.pixelOf(marks_[i].place);
        if (!at) continue;
        const double distance = std::hypot(at->x() - pixel.x(), at->y() - pixel.y());
        if (distance > least) continue;
        least = distance;
        nearest = i;
    }
    return nearest;
}

void PlaceMarks::paint(QPainter& painter, const QRect& area, const ViewProjection& view) const {
    for (std::size_t i = 0; i < marks_.size(); ++i)
        if (const auto at = view.pixelOf(marks_[i].place))
            paintPlaceMark(painter, area, *at, marks_[i].color,
                           marks_.size() <= labelLimit ? marks_[i].label : QString());
}

void paintPlaceMark(QPainter& painter, const QRect& area, const QPointF& at, const QColor& color,
                    const QString& label) {
    if (!QRectF(area).contains(at)) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(QColor(0, 0, 0, 190), 4.5), QPen(Qt::white, 3), QPen(color, 2)}) {
        painter.setPen(pen);
        painter.drawEllipse(at, ring, ring);
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::white);
    painter.drawEllipse(at, 1.5, 1.5);
    if (!label.isEmpty()) {
        const QRectF room = QRectF(area).adjusted(4, 2, -4, -2);
        const QSizeF padding(14, 6);
        const QString shown = painter.fontMetrics().elidedText(
            label, Qt::ElideRight, static_cast<int>(room.width() - padding.width()));
        QRectF box = painter.fontMetrics().boundingRect(shown);
        box.setSize(box.size() + padding);
        box.moveTopLeft(at + QPointF(ring + 6, -box.height() / 2));
        if (box.right() > room.right()) box.moveRight(at.x() - ring - 6);
        if (box.left() < room.left()) {
            // Neither side has room: above the ring, or below it.
            box.moveLeft(std::clamp(at.x() - box.width() / 2, room.left(),
                                    std::max(room.left(), room.right() - box.width())));
            box.moveBottom(at.y() - ring - 6);
            if (box.top() < room.top()) box.moveTop(at.y() + ring + 6);
        }
        box.moveTop(std::clamp(box.top(), room.top(), std::max(room.top(), room.bottom() - box.height())));
        painter.setBrush(QColor(0x2b, 0x2e, 0x33, 225));
        painter.drawRoundedRect(box, 4, 4);
        painter.setPen(Qt::white);
        painter.drawText(box, Qt::AlignCenter, shown);
    }
    painter.restore();
}

}  // namespace isoscope
