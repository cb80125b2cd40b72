// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/pane_walk.h"

#include <algorithm>
#include <QApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <QMainWindow>
#include <QPainter>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>

#include "app/desktop/window/docks.h"

namespace isoscope {

namespace {

/// Lets the mouse through.
class PaneFrame : public QWidget {
  public:
    explicit PaneFrame(QWidget* parent) : QWidget(parent) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        hide();
    }

  protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
};

/// Not behind another panel, which Qt moves out of the window, nor folded or scrolled away.
bool isSeen(const QWidget* widget) {
    if (!widget->isVisible()) return false;
    QRect seen = widget->rect();
    for (; !widget->isWindow(); widget = widget->parentWidget())
        seen = seen.translated(widget->pos()) & widget->parentWidget()->rect();
    return !seen.isEmpty();
}

bool takesKeys(const QWidget* widget) {
    return widget->isEnabled() && isSeen(widget) && (widget->focusPolicy() & Qt::TabFocus) == Qt::TabFocus;
}

QList<QToolButton*> buttons(const QToolBar* bar) {
    QList<QToolButton*> found;
    for (auto* button : bar->findChildren<QToolButton*>())
        if (button->isEnabled() && isSeen(button) &&
            button->objectName() != QLatin1String("qt_toolbar_ext_button"))
            found << button;
    std::sort(found.begin(), found.end(), [](auto* a, auto* b) { return a->x() < b->x(); });
    return found;
}

}  // namespace

PaneWalk::PaneWalk(QMainWindow* window, const Docks* docks, QWidget* picture)
    : QObject(window), window_(window), docks_(docks), picture_(picture), frame_(new PaneFrame(window)) {
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
        if (marked_ && now && now != marked_ && !marked_->isAncestorOf(now)) unmark();
    });
}

QWidget* PaneWalk::target(const QWidget* pane) {
    if (const auto* bar = qobject_cast<const QToolBar*>(pane)) {
        const QList<QToolButton*> all = buttons(bar);
        auto* last = qobject_cast<QToolButton*>(bar->focusWidget());
        return all.contains(last) ? last : all.value(0);
    }
    if (takesKeys(pane)) return const_cast<QWidget*>(pane);
    if (QWidget* last = pane->focusWidget(); last && takesKeys(last)) return last;
    QWidget* first = nullptr;
    // In the order of Tab; the chain is a ring over the whole window.
    for (QWidget* next = pane->nextInFocusChain(); next != pane && !first; next = next->nextInFocusChain())
        if (pane->isAncestorOf(next) && takesKeys(next)) first = next;
    return first;
}

QList<QWidget*> PaneWalk::panes() const {
    QList<QWidget*> all;
    const auto add = [&](QWidget* pane) {
        if (isSeen(pane) && target(pane)) all << pane;
    };
    for (const auto place : {Docks::Place::upperLeft, Docks::Place::lowerLeft})
        for (QDockWidget* dock : docks_->at(place)) add(dock);
    add(cover_ && cover_->isVisible() ? cover_.data() : picture_);
    for (const auto place : {Docks::Place::below, Docks::Place::right})
        for (QDockWidget* dock : docks_->at(place)) add(dock);
    for (QToolBar* bar : window_->findChildren<QToolBar*>(QString(), Qt::FindDirectChildrenOnly)) add(bar);
    for (QStatusBar* bar : window_->findChildren<QStatusBar*>(QString(), Qt::FindDirectChildrenOnly))
        add(bar);
    return all;
}

void PaneWalk::go(bool forward) {
    const QList<QWidget*> all = panes();
    if (all.isEmpty()) return;
    const QWidget* focus = QApplication::focusWidget();
    const auto here = std::find_if(all.begin(), all.end(), [&](const QWidget* pane) {
        return focus && (pane == focus || pane->isAncestorOf(focus));
    });
    const qsizetype count = all.size(), step = forward ? 1 : count - 1;
    const qsizetype at = here == all.end() ? (forward ? count - 1 : 0) : here - all.begin();
    QWidget* pane = all[(at + step) % count];
    QWidget* focused = target(pane);
    if (pane->window() != window_) pane->window()->activateWindow();
    focused->setFocus(Qt::TabFocusReason);
    mark(qobject_cast<QToolBar*>(pane) ? focused : pane);
}

void PaneWalk::mark(QWidget* pane) {
    unmark();
    if (!frame_) return;
    marked_ = pane;
    qApp->installEventFilter(this);
    frame_->setParent(pane);
    frame_->setGeometry(pane->rect());
    frame_->show();
    frame_->raise();
}

void PaneWalk::unmark() {
    qApp->removeEventFilter(this);
    marked_ = nullptr;
    if (!frame_) return;
    frame_->hide();
    frame_->setParent(window_);
}

bool PaneWalk::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonPress) unmark();
    if (marked_ && frame_ && watched == marked_ && event->type() == QEvent::Resize)
        frame_->setGeometry(marked_->rect());
    // Tool buttons are no stops of Tab: the arrows go from one to the next.
    auto* button = qobject_cast<QToolButton*>(watched);
    const auto* bar = button ? qobject_cast<QToolBar*>(button->parentWidget()) : nullptr;
    if (!bar || event->type() != QEvent::KeyPress || !button->hasFocus()) return false;
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key != Qt::Key_Left && key != Qt::Key_Right) return false;
    const QList<QToolButton*> all = buttons(bar);
    const qsizetype to = all.indexOf(button) + (key == Qt::Key_Left ? -1 : 1);
    if (to < 0 || to >= all.size()) return true;
    all[to]->setFocus(Qt::TabFocusReason);
    mark(all[to]);
    return true;
}

}  // namespace isoscope
