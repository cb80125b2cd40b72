// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/overlay_bar.h"

#include <algorithm>
#include <cmath>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QToolButton>

#include "widgets/interface_style.h"
#include "widgets/viewport/view_overlay.h"

namespace isoscope {

namespace {

constexpr int margin = 10;
/// Kept free at the right, for the busy mark.
constexpr int rightMargin = 44;

}  // namespace

OverlayBar::OverlayBar(ViewOverlay* overlay, QWidget* viewport) : QWidget(viewport), overlay_(overlay) {
    // As the legends, on whatever picture: not the colours of the theme.
    QPalette colors;
    colors.setColor(QPalette::WindowText, Qt::white);
    setPalette(colors);
    setCursor(Qt::ArrowCursor);
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(9, 4, 9, 4);
    text_ = new QLabel;
    text_->setPalette(colors);
    text_->setWordWrap(true);
    text_->setTextFormat(Qt::PlainText);
    text_->setAccessibleDescription(tr("What the overlay shows"));
    text_->setToolTip(tr("Counted in the pixels of this picture, with the settings of the text"));
    line->addWidget(text_, 1);
    progress_ = new QProgressBar;
    progress_->setRange(0, 100);
    progress_->setFixedSize(interfaceLength(90), interfaceLength(14));
    progress_->setTextVisible(false);
    progress_->setAccessibleName(tr("Progress of the overlay"));
    progress_->setToolTip(tr("How much of the overlay is computed"));
    line->addWidget(progress_);
    stop_ = new QToolButton;
    stop_->setText(tr("Stop"));
    stop_->setAccessibleName(tr("Stop computing the overlay"));
    stop_->setToolTip(tr("Stop computing the overlay"));
    connect(stop_, &QToolButton::clicked, overlay, &ViewOverlay::stop);
    line->addWidget(stop_);
    viewport->installEventFilter(this);
    connect(overlay, &ViewOverlay::changed, this, &OverlayBar::refresh);
    refresh();
}

QString OverlayBar::text() const { return text_->text(); }

void OverlayBar::refresh() {
    setVisible(overlay_->kind() != OverlayKind::none);
    text_->setText(overlay_->summary());
    const bool slow = overlay_->slow();
    progress_->setVisible(slow);
    progress_->setValue(static_cast<int>(std::lround(100 * overlay_->share())));
    stop_->setVisible(slow);
    place();
}

void OverlayBar::place() {
    const int most = parentWidget()->width() - margin - rightMargin;
    // A label that wraps prefers to be narrow; here it is to be as wide as its text.
    const QMargins inner = layout()->contentsMargins();
    int width = text_->fontMetrics().horizontalAdvance(text_->text()) + inner.left() + inner.right() + 4;
    if (stop_->isVisibleTo(this))
        width += progress_->width() + stop_->sizeHint().width() + 2 * layout()->spacing();
    width = std::clamp(width, 1, std::max(1, most));
    setGeometry(margin, margin, width,
                std::max(layout()->heightForWidth(width), layout()->minimumSize().height()));
}

bool OverlayBar::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) place();
    return QWidget::eventFilter(watched, event);
}

void OverlayBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0x2b, 0x2e, 0x33, 225));
    painter.drawRoundedRect(rect(), 5, 5);
}

}  // namespace isoscope
