// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/timeline_view.h"

#include <algorithm>
#include <cmath>
#include <QApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QToolTip>
#include <QWheelEvent>

namespace isoscope {

namespace {

constexpr int sidePadding = 10;  ///< beside the first and the last frame
constexpr int headerShare = 5;   ///< the names take one part of so many
constexpr int leastHeader = 90;  // pixels
constexpr int mostHeader = 220;
constexpr int keySize = 5;    ///< half of a key's width
constexpr int headSize = 6;   ///< of the mark at the present frame
constexpr int reach = 7;      ///< how near a key the mouse must be
constexpr int tickRoom = 52;  ///< between two numbers of the ruler
constexpr int leastRows = 2;
constexpr int chosenAlpha = 40;  ///< of 255
constexpr int manyFrames = 10;   ///< of Page Up and Page Down

/// 1, 2, 5, 10, ...: so that numbers of the ruler have room.
int tickStep(double framesPerPixel) {
    for (long long step = 1; step <= mostFrames; step *= 10)
        for (const int times : {1, 2, 5})
            if (static_cast<double>(step * times) >= framesPerPixel * tickRoom)
                return static_cast<int>(step * times);
    return mostFrames;
}

}  // namespace

TimelineView::TimelineView(QWidget* parent) : QWidget(parent), scroll_(new QScrollBar(this)) {
    scroll_->hide();
    connect(scroll_, &QScrollBar::valueChanged, this, qOverload<>(&QWidget::update));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(false);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Frames and keys"));
    setToolTip(tr("Drag to go to a frame, drag a key to move it; a right click on a key has more"));
}

void TimelineView::setTimeline(const Timeline& timeline, const std::vector<std::string>& missing) {
    const QString title = row() ? row()->title : QString();
    timeline_ = timeline;
    rows_ = timelineRows(timeline, missing);
    const auto same =
        std::find_if(rows_.begin(), rows_.end(), [&](const TimelineRow& row) { return row.title == title; });
    const int last = std::max(0, static_cast<int>(rows_.size()) - 1);
    chosen_ = same == rows_.end() ? std::min(chosen_, last) : static_cast<int>(same - rows_.begin());
    updateGeometry();
    placeScrollBar();
    update();
    tellPlace();
}

void TimelineView::setFrame(int frame) {
    if (frame == frame_) return;
    frame_ = frame;
    update();
    tellPlace();
}

const TimelineRow* TimelineView::row() const {
    return chosen_ >= 0 && chosen_ < static_cast<int>(rows_.size())
               ? &rows_[static_cast<std::size_t>(chosen_)]
               : nullptr;
}

void TimelineView::chooseRow(int index) {
    if (index < 0 || index >= static_cast<int>(rows_.size()) || index == chosen_) return;
    chosen_ = index;
    const int top = index * rowHeight(), room = height() - rulerHeight();
    scroll_->setValue(std::clamp(scroll_->value(), top + rowHeight() - room, top));
    update();
    tellPlace();
    emit rowChosen();
}

/// For screen readers, which see no drawing.
void TimelineView::tellPlace() {
    QString told =
        tr("Frame %1 of %2 to %3").arg(frame_).arg(timeline_.frames.first).arg(timeline_.frames.last);
    if (row()) {
        const QString keys = row()->told(timeline_, frame_);
        told += QStringLiteral("; ") + (keys.isEmpty() ? tr("%1 has no key here").arg(row()->title) : keys);
    }
    if (told == accessibleDescription()) return;
    setAccessibleDescription(told);
}

int TimelineView::rulerHeight() const { return fontMetrics().height() + 8; }
int TimelineView::rowHeight() const { return fontMetrics().height() + 6; }

QSize TimelineView::minimumSizeHint() const {
    return {leastHeader + 4 * tickRoom, rulerHeight() + leastRows * rowHeight() + 2};
}

QSize TimelineView::sizeHint() const {
    const int rows = std::max(leastRows, static_cast<int>(rows_.size()));
    return {minimumSizeHint().width(), rulerHeight() + rows * rowHeight() + 2};
}

void TimelineView::placeScrollBar() {
    const int room = height() - rulerHeight();
    const int more = static_cast<int>(rows_.size()) * rowHeight() - room;
    const int wide = scroll_->sizeHint().width();
    scroll_->setGeometry(width() - wide, rulerHeight(), wide, room);
    scroll_->setPageStep(room);
    scroll_->setSingleStep(rowHeight());
    scroll_->setRange(0, std::max(0, more));
    scroll_->setVisible(more > 0);
}

void TimelineView::resizeEvent(QResizeEvent*) { placeScrollBar(); }

void TimelineView::wheelEvent(QWheelEvent* event) {
    if (scroll_->isVisible())
        QApplication::sendEvent(scroll_, event);
    else
        event->ignore();
}

QRect TimelineView::band() const {
    const int header = std::clamp(width() / headerShare, leastHeader, mostHeader);
    const int bar = scroll_->isHidden() ? 0 : scroll_->width();
    return {header + sidePadding, 0, std::max(1, width() - header - 2 * sidePadding - bar), height()};
}

double TimelineView::x(int frame) const {
    const double count = std::max(1, timeline_.frames.last - timeline_.frames.first);
    return band().left() + band().width() * (double(frame) - timeline_.frames.first) / count;
}

int TimelineView::frameAtX(double x) const {
    const double count = timeline_.frames.last - timeline_.frames.first;
    const double share = std::clamp((x - band().left()) / band().width(), 0.0, 1.0);
    return timeline_.frames.first + static_cast<int>(std::lround(share * count));
}

int TimelineView::rowAt(int y) const {
    return y < rulerHeight() ? -1 : (y - rulerHeight() + scroll_->value()) / rowHeight();
}

QPoint TimelineView::placeOf(int frame, int row) const {
    return {static_cast<int>(std::lround(x(frame))),
            rulerHeight() + row * rowHeight() + rowHeight() / 2 - scroll_->value()};
}

std::optional<TimelineView::Place> TimelineView::keyAt(QPoint place) const {
    const int index = rowAt(place.y());
    if (index < 0 || index >= static_cast<int>(rows_.size())) return std::nullopt;
    std::optional<Place> nearest;
    double distance = reach + 1;
    for (const int frame : rows_[static_cast<std::size_t>(index)].frames(timeline_)) {
        const double away = std::abs(x(frame) - place.x());
        if (away >= distance) continue;
        distance = away;
        nearest = Place{index, frame};
    }
    return nearest;
}

void TimelineView::pick(int frame) {
    frame = std::clamp(frame, timeline_.frames.first, timeline_.frames.last);
    if (frame == frame_) return;
    setFrame(frame);
    emit framePicked(frame);
}

void TimelineView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton && event->button() != Qt::RightButton) return;
    const QPoint place = event->position().toPoint();
    const auto key = keyAt(place);
    if (const int index = rowAt(place.y()); index >= 0) chooseRow(index);
    if (!key && (event->button() == Qt::RightButton || place.x() < band().left() - sidePadding)) return;
    dragging_ = true;
    pick(key ? key->frame : frameAtX(place.x()));
    if (event->button() == Qt::RightButton) {
        dragging_ = false;
        emit frameReleased();
        return;
    }
    held_ = key;
    heldAt_ = frame_;
}

void TimelineView::mouseMoveEvent(QMouseEvent* event) {
    if (!dragging_) return;
    const int frame = frameAtX(event->position().x());
    if (!held_) return pick(frame);
    heldAt_ = frame;
    update();
}

void TimelineView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !std::exchange(dragging_, false)) return;
    const auto held = std::exchange(held_, std::nullopt);
    if (held && heldAt_ != held->frame) {
        emit frameReleased();
        emit keyMoved(held->row, held->frame, heldAt_);
        pick(heldAt_);
    }
    emit frameReleased();
    update();
}

void TimelineView::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Left: return pick(frame_ - 1);
        case Qt::Key_Right: return pick(frame_ + 1);
        case Qt::Key_PageDown: return pick(frame_ + manyFrames);
        case Qt::Key_PageUp: return pick(frame_ - manyFrames);
        case Qt::Key_Home: return pick(timeline_.frames.first);
        case Qt::Key_End: return pick(timeline_.frames.last);
        case Qt::Key_Up: return chooseRow(chosen_ - 1);
        case Qt::Key_Down: return chooseRow(chosen_ + 1);
        case Qt::Key_Delete:
        case Qt::Key_Backspace: emit removeRequested(); return;
        default: QWidget::keyPressEvent(event);
    }
}

void TimelineView::contextMenuEvent(QContextMenuEvent* event) {
    const bool byMouse = event->reason() == QContextMenuEvent::Mouse;
    if (!row() || (byMouse && !keyAt(event->pos()))) return event->ignore();
    emit menuRequested(byMouse ? event->globalPos() : mapToGlobal(placeOf(frame_, chosen_)));
}

bool TimelineView::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const auto key = keyAt(help->pos());
    if (!key) return QWidget::event(event);
    QToolTip::showText(help->globalPos(),
                       rows_[static_cast<std::size_t>(key->row)].told(timeline_, key->frame), this);
    return true;
}

void TimelineView::paintRuler(QPainter& painter) const {
    const FrameSequence& frames = timeline_.frames;
    const double count = std::max(1, frames.last - frames.first);
    const int step = tickStep(count / band().width());
    painter.setPen(palette().color(QPalette::PlaceholderText));
    for (long long frame = (static_cast<long long>(frames.first) + step - 1) / step * step;
         frame <= frames.last; frame += step) {
        const int at = static_cast<int>(std::lround(x(static_cast<int>(frame))));
        painter.drawLine(at, rulerHeight() - 5, at, rulerHeight() - 1);
        painter.drawText(QRect(at - tickRoom / 2, 0, tickRoom, rulerHeight() - 5), Qt::AlignCenter,
                         QString::number(frame));
    }
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawLine(0, rulerHeight() - 1, width(), rulerHeight() - 1);
}

void TimelineView::paintRow(QPainter& painter, int index) const {
    const TimelineRow& row = rows_[static_cast<std::size_t>(index)];
    const QRect area(0, rulerHeight() + index * rowHeight() - scroll_->value(), width(), rowHeight());
    if (index == chosen_) {
        QColor chosen = palette().color(QPalette::Highlight);
        chosen.setAlpha(chosenAlpha);
        painter.fillRect(area, chosen);
    }
    painter.setPen(palette().color(row.missing ? QPalette::PlaceholderText : QPalette::Text));
    const QRect title = area.adjusted(6, 0, band().left() - sidePadding - width() - 4, 0);
    const QString words = row.missing ? tr("%1 (not in the text)").arg(row.title) : row.title;
    painter.drawText(title, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(words, Qt::ElideRight, title.width()));
    const std::set<int> frames = row.frames(timeline_);
    const QColor line = palette().color(QPalette::Mid);
    if (frames.size() > 1) {
        painter.setPen(line);
        const int y = area.center().y();
        painter.drawLine(QPointF(std::clamp<double>(x(*frames.begin()), band().left(), band().right()), y),
                         QPointF(std::clamp<double>(x(*frames.rbegin()), band().left(), band().right()), y));
    }
    for (const int frame : frames) {
        const bool moved = held_ && held_->row == index && held_->frame == frame;
        const int at = moved ? heldAt_ : frame;
        if (at < timeline_.frames.first || at > timeline_.frames.last) continue;
        const QPoint place = placeOf(at, index);
        const bool present = at == frame_ && index == chosen_;
        painter.setPen(palette().color(QPalette::Text));
        painter.setBrush(palette().color(present ? QPalette::Highlight : QPalette::Button));
        painter.drawPolygon(QPolygon({place - QPoint(keySize, 0), place - QPoint(0, keySize),
                                      place + QPoint(keySize, 0), place + QPoint(0, keySize)}));
    }
}

void TimelineView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    painter.setRenderHint(QPainter::Antialiasing);
    paintRuler(painter);
    if (frame_ >= timeline_.frames.first && frame_ <= timeline_.frames.last) {
        const int at = static_cast<int>(std::lround(x(frame_))), top = rulerHeight() - 1;
        const QColor color = palette().color(QPalette::Highlight);
        painter.setPen(QPen(color, 2));
        painter.drawLine(at, top, at, height());
        painter.setPen(Qt::NoPen);
        painter.setBrush(color);
        painter.drawPolygon(
            QPolygon({{at - headSize, top - headSize}, {at + headSize, top - headSize}, {at, top + 2}}));
    }
    painter.setClipRect(0, rulerHeight(), width(), height() - rulerHeight());
    for (int i = 0; i < static_cast<int>(rows_.size()); ++i) paintRow(painter, i);
    painter.setClipping(false);
    if (rows_.empty()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(QRect(0, rulerHeight(), width(), height() - rulerHeight()), Qt::AlignCenter,
                         tr("No keys yet: go to a frame, move a slider or the view, and choose Set Key."));
    }
    if (hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(palette().color(QPalette::Highlight));
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

}  // namespace isoscope
