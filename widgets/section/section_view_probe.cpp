// SPDX-License-Identifier: GPL-3.0-or-later
// Of SectionView: what is under the mouse, marked places and the probed point.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <QKeyEvent>
#include <QPainter>

#include "widgets/linked_probe.h"
#include "widgets/section/section_view.h"
#include "widgets/viewport/place_marks.h"

namespace isoscope {

namespace {

constexpr double keySteps = 100, fineKeySteps = 1000;  ///< of the crosshair, across the section

/// Whether the plane passes through a place that is `away` from it, as far as an eye can tell.
bool lies(double away, const SectionField& field) {
    return std::abs(away) <= 0.01 * (field.right - field.left);
}

}  // namespace

void SectionView::markPlace(std::optional<MarkedPlace> mark) {
    if (mark == marked_) return;
    marked_ = std::move(mark);
    update();
}

std::optional<QPointF> SectionView::markPixel() const {
    if (!marked_ || field_.empty()) return {};
    const glm::dvec2 foot = field_.plane.footOf(marked_->place);
    return toPixel({foot.x, foot.y});
}

void SectionView::drawMark() {
    const auto at = markPixel();
    if (!at) return;
    const double away = awayFrom(marked_->place);
    QPainter painter(this);
    paintPlaceMark(painter, QRect(0, 0, static_cast<int>(planeWidth()), height()), *at, marked_->color,
                   lies(away, field_)
                       ? marked_->label
                       : tr("%1, %2 away").arg(marked_->label, QString::number(std::abs(away), 'g', 2)));
}

void SectionView::drawFocus() {
    QPainter painter(this);
    painter.setPen(QPen(palette().highlight(), 1));
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

void SectionView::showProbe(std::optional<glm::dvec3> place) {
    if (place == probe_) return;
    probe_ = place;
    update();
}

std::optional<QPointF> SectionView::probePixel() const {
    if (!probe_ || field_.empty() || hover_) return {};
    const glm::dvec2 foot = field_.plane.footOf(*probe_);
    return toPixel({foot.x, foot.y});
}

void SectionView::drawProbe() {
    const auto at = probePixel();
    if (!at) return;
    constexpr double inner = 3, outer = 10;
    QPainter painter(this);
    painter.setClipRect(QRectF(0, 0, planeWidth(), height()));
    painter.setRenderHint(QPainter::Antialiasing);
    if (!lies(awayFrom(*probe_), field_)) painter.setOpacity(0.5);
    for (const QPen& pen : {QPen(palette().base(), 4), QPen(probeColor(palette()), 2)}) {
        painter.setPen(pen);
        for (const QPointF way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            painter.drawLine(*at + inner * way, *at + outer * way);
    }
}

double SectionView::awayFrom(const glm::dvec3& place) const {
    const glm::dvec2 foot = field_.plane.footOf(place);
    return glm::dot(place - field_.plane.at(foot.x, foot.y), field_.plane.normal());
}

void SectionView::tellHover() {
    if (!hover_ || field_.empty()) return;
    const QPointF place = toPlane(*hover_);
    const double column = (place.x() - field_.left) / (field_.right - field_.left) * (field_.columns - 1);
    const double row = (place.y() - field_.bottom) / (field_.top - field_.bottom) * (field_.rows - 1);
    if (column < 0 || row < 0 || column > field_.columns - 1 || row > field_.rows - 1) return endHover();
    emit hovered(place.x(), place.y(),
                 static_cast<std::size_t>(std::lround(row) * field_.columns + std::lround(column)));
}

void SectionView::keyPressEvent(QKeyEvent* event) {
    const int across = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
    const int up = event->key() == Qt::Key_Up ? 1 : event->key() == Qt::Key_Down ? -1 : 0;
    if (event->modifiers() & ~Qt::ShiftModifier & ~Qt::KeypadModifier || field_.empty())
        return VtkPanel::keyPressEvent(event);
    if (event->key() == Qt::Key_Escape && hover_) return endHover();
    if (across == 0 && up == 0) return VtkPanel::keyPressEvent(event);
    const QRectF limits(QPointF(field_.left, field_.bottom), QPointF(field_.right, field_.top));
    QPointF place = limits.center();
    if (const auto from = hover_ ? hover_ : probePixel()) {
        const bool fine = event->modifiers() & Qt::ShiftModifier;
        place = toPlane(*from) + QPointF(across, up) * limits.width() / (fine ? fineKeySteps : keySteps);
    }
    // A hair within: what comes back from pixels may else lie outside.
    const double rim = 1e-9 * limits.width();
    hover_ = toPixel({std::clamp(place.x(), limits.left() + rim, limits.right() - rim),
                      std::clamp(place.y(), limits.top() + rim, limits.bottom() - rim)});
    tellHover();
    update();
}

void SectionView::focusOutEvent(QFocusEvent* event) {
    VtkPanel::focusOutEvent(event);
    if (!underMouse() && hover_) endHover();
}

void SectionView::endHover() {
    hover_.reset();
    update();
    emit hoverEnded();
}

}  // namespace isoscope
