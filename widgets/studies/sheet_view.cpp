// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/sheet_view.h"

#include <algorithm>
#include <QMouseEvent>
#include <QPainter>

namespace isoscope {

SheetView::SheetView(QWidget* parent) : QWidget(parent) { setMinimumSize(80, 60); }

void SheetView::setImage(const QImage& image) {
    image_ = image;
    setCursor(image_.isNull() ? Qt::ArrowCursor : Qt::PointingHandCursor);
    update();
}

void SheetView::setEmptyText(const QString& text) {
    empty_ = text;
    update();
}

QRectF SheetView::frame() const {
    if (image_.isNull()) return {};
    const double scale = std::min({1.0, static_cast<double>(width()) / image_.width(),
                                   static_cast<double>(height()) / image_.height()});
    const QSizeF size(image_.width() * scale, image_.height() * scale);
    return {QPointF((width() - size.width()) / 2, (height() - size.height()) / 2), size};
}

QPoint SheetView::placeOf(QPoint pixel) const {
    const QRectF shown = frame();
    return (shown.topLeft() +
            (QPointF(pixel) + QPointF(0.5, 0.5)) * (shown.width() / std::max(1, image_.width())))
        .toPoint();
}

void SheetView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (image_.isNull()) {
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(rect(), static_cast<int>(Qt::AlignCenter) | Qt::TextWordWrap, empty_);
        return;
    }
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(frame(), image_);
}

void SheetView::mouseReleaseEvent(QMouseEvent* event) {
    const QRectF shown = frame();
    if (event->button() != Qt::LeftButton || !shown.contains(event->position())) return;
    const QPointF at = (event->position() - shown.topLeft()) * (image_.width() / shown.width());
    emit clicked({static_cast<int>(at.x()), static_cast<int>(at.y())});
}

}  // namespace isoscope
