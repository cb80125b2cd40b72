// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/tool_row.h"

#include <QEvent>
#include <QLayout>
#include <QMainWindow>
#include <QToolBar>
#include <QToolButton>

namespace isoscope {

ToolRow::ToolRow(QMainWindow* window, const QList<QToolBar*>& bars, const QList<QToolButton*>& worded)
    : QObject(window), window_(window), bars_(bars), worded_(worded) {
    window->installEventFilter(this);
    showWords(true);
}

bool ToolRow::eventFilter(QObject* watched, QEvent* event) {
    const bool fits = event->type() == QEvent::Resize || event->type() == QEvent::Show;
    if (watched == window_ && fits) fit();
    return QObject::eventFilter(watched, event);
}

int ToolRow::wantedWidth() const {
    int width = 0;
    for (const QToolBar* bar : bars_)
        if (!bar->isHidden() && !bar->isFloating()) width += bar->sizeHint().width();
    return width;
}

void ToolRow::fit() {
    if (!wordsShown_) showWords(true);
    if (wantedWidth() > window_->width()) showWords(false);
}

void ToolRow::showWords(bool shown) {
    wordsShown_ = shown;
    for (QToolButton* button : worded_)
        button->setToolButtonStyle(shown ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
    for (QToolBar* bar : bars_) bar->layout()->invalidate();
}

}  // namespace isoscope
