// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/probe_mark.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWidget>

namespace isoscope {

namespace {

constexpr double inner = 3, outer = 9;
constexpr int reach = 13;  ///< of all that is painted, in pixels

QRect around(const QPointF& at) {
    return QRect(at.toPoint() - QPoint(reach, reach), QSize(2 * reach + 1, 2 * reach + 1));
}

}  // namespace

void ProbeMark::set(const std::optional<glm::dvec3>& point) {
    if (point == point_) return;
    point_ = point;
    emit changed();
}

void ProbeMark::paint(QPainter& painter, const ViewProjection& view) const {
    painted_ = {};
    const auto at = point_ ? view.pixelOf(*point_) : std::nullopt;
    if (!at) return;
    painted_ = around(*at);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    // Seen on light and dark pictures.
    for (const QPen& pen : {QPen(QColor(0, 0, 0, 190), 4), QPen(QColor(0xf0, 0x8c, 0xff), 2)}) {
        painter.setPen(pen);
        for (const QPointF way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            painter.drawLine(*at + inner * way, *at + outer * way);
    }
    painter.restore();
}

QRect ProbeMark::stale(const ViewProjection& view) const {
    const auto at = point_ ? view.pixelOf(*point_) : std::nullopt;
    return at ? painted_.united(around(*at)) : painted_;
}

HoverWatch::HoverWatch(QWidget* watched) : QObject(watched) { watched->installEventFilter(this); }

bool HoverWatch::eventFilter(QObject*, QEvent* event) {
    if (event->type() == QEvent::MouseMove) {
        const auto* move = static_cast<QMouseEvent*>(event);
        move->buttons() == Qt::NoButton ? emit hovered(move->position()) : emit ended();
    }
    if (event->type() == QEvent::Leave || event->type() == QEvent::MouseButtonPress) emit ended();
    return false;
}

}  // namespace isoscope
