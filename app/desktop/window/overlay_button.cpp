// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/overlay_button.h"

#include <algorithm>
#include <QMenu>
#include <QStyleOptionToolButton>
#include <QStylePainter>

#include "widgets/icons.h"

namespace isoscope {

namespace {

constexpr int arrowEdge = 9;
constexpr int gap = 4;  ///< between icon, name and arrow

}  // namespace

OverlayButton::OverlayButton(const QList<QAction*>& choices, QWidget* parent)
    : QToolButton(parent), choices_(choices) {
    setIcon(themeIcon(QStringLiteral("layer-visible-on")));
    setPopupMode(QToolButton::InstantPopup);
    setMenu(new QMenu(this));
    menu()->addActions(choices);
    menu()->setToolTipsVisible(true);
    setToolTip(tr("What is laid over the picture: holes of POV-Ray's method, or the gradient"));
    setAccessibleName(tr("Overlay of the picture"));
    for (QAction* choice : choices) {
        const auto tell = [this, choice] {
            setText(choice->iconText());
            setAccessibleDescription(choice->iconText());
        };
        if (choice->isChecked()) tell();
        connect(choice, &QAction::toggled, this, [tell](bool on) {
            if (on) tell();
        });
    }
}

QSize OverlayButton::sizeHint() const {
    const QSize present = QToolButton::sizeHint();
    if (toolButtonStyle() == Qt::ToolButtonIconOnly) return present;
    int widest = 0;
    for (const QAction* choice : choices_)
        widest = std::max(widest, fontMetrics().horizontalAdvance(choice->iconText()));
    return present + QSize(widest - fontMetrics().horizontalAdvance(text()) + gap + arrowEdge, 0);
}

int OverlayButton::nameEnd() const {
    // As Qt's styles place icon and name beside each other.
    const int frame = style()->pixelMetric(QStyle::PM_DefaultFrameWidth, nullptr, this);
    return frame + iconSize().width() + gap + fontMetrics().horizontalAdvance(text());
}

QRect OverlayButton::arrow() const {
    return {nameEnd() + gap, (height() - arrowEdge) / 2 + 1, arrowEdge, arrowEdge};
}

void OverlayButton::paintEvent(QPaintEvent* event) {
    if (toolButtonStyle() == Qt::ToolButtonIconOnly) return QToolButton::paintEvent(event);
    QStylePainter painter(this);
    QStyleOptionToolButton option;
    initStyleOption(&option);
    // The style's arrow stands in the corner of the button, far from a short name.
    option.features &= ~QStyleOptionToolButton::ToolButtonFeatures(QStyleOptionToolButton::HasMenu);
    painter.drawComplexControl(QStyle::CC_ToolButton, option);
    QStyleOption small = option;
    small.rect = arrow();
    painter.drawPrimitive(QStyle::PE_IndicatorArrowDown, small);
}

}  // namespace isoscope
