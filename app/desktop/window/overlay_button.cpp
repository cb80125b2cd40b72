// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/overlay_button.h"

#include <algorithm>
#include <QMenu>

#include "widgets/icons.h"

namespace isoscope {

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
    return present + QSize(widest - fontMetrics().horizontalAdvance(text()), 0);
}

}  // namespace isoscope
