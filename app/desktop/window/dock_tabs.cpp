// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/dock_tabs.h"

#include <algorithm>
#include <QChildEvent>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QTabBar>

namespace isoscope {

DockTabs::DockTabs(QMainWindow* window, const QList<QDockWidget*>& docks)
    : QObject(window), window_(window), docks_(docks) {
    refreshTimer_.setSingleShot(true);
    refreshTimer_.setInterval(0);
    connect(&refreshTimer_, &QTimer::timeout, this, &DockTabs::refresh);
    for (QDockWidget* dock : docks) watch(dock);
    window->installEventFilter(this);
    refresh();
}

void DockTabs::watch(QDockWidget* dock) {
    const auto later = [this] { refreshTimer_.start(); };
    connect(dock, &QDockWidget::visibilityChanged, this, later);
    connect(dock, &QDockWidget::topLevelChanged, this, later);
    connect(dock, &QDockWidget::dockLocationChanged, this, later);
}

void DockTabs::add(QDockWidget* dock) {
    docks_ << dock;
    watch(dock);
    refreshTimer_.start();
}

bool DockTabs::eventFilter(QObject* watched, QEvent* event) {
    // The window makes its rows of tabs when it needs them, also when it restores a layout.
    if (watched == window_ && event->type() == QEvent::ChildPolished)
        if (qobject_cast<QTabBar*>(static_cast<QChildEvent*>(event)->child())) refreshTimer_.start();
    return QObject::eventFilter(watched, event);
}

QDockWidget* DockTabs::dockAt(const QTabBar* bar, int index) const {
    // The window notes in each tab the address of its dock.
    const auto address = bar->tabData(index).value<quintptr>();
    const auto dock = std::find_if(docks_.begin(), docks_.end(), [address](QDockWidget* known) {
        return reinterpret_cast<quintptr>(known) == address;
    });
    return dock == docks_.end() ? nullptr : *dock;
}

QList<QDockWidget*> DockTabs::docksOf(const QTabBar* bar) const {
    QList<QDockWidget*> docks;
    for (int i = 0; bar && i < bar->count(); ++i)
        if (QDockWidget* dock = dockAt(bar, i)) docks << dock;
    return docks;
}

QTabBar* DockTabs::barOf(const QDockWidget* dock) const {
    for (QTabBar* bar : window_->findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
        if (bar->isVisibleTo(window_) && docksOf(bar).contains(dock)) return bar;
    return nullptr;
}

bool DockTabs::tabbed(QDockWidget* dock) const {
    if (dock->isHidden() || dock->isFloating()) return false;
    const QList<QDockWidget*> others = window_->tabifiedDockWidgets(dock);
    return std::any_of(others.begin(), others.end(),
                       [](QDockWidget* other) { return !other->isHidden() && !other->isFloating(); });
}

void DockTabs::refresh() {
    for (QDockWidget* dock : docks_) {
        const bool wanted = !tabbed(dock);
        if (wanted == !dock->titleBarWidget()) continue;
        QWidget* none = dock->titleBarWidget();
        dock->setTitleBarWidget(wanted ? nullptr : new QWidget(dock));
        delete none;
    }
    for (QTabBar* bar : window_->findChildren<QTabBar*>(Qt::FindDirectChildrenOnly)) prepare(bar);
    emit changed();
}

void DockTabs::prepare(QTabBar* bar) {
    if (bar->contextMenuPolicy() == Qt::CustomContextMenu) return;
    bar->setElideMode(Qt::ElideNone);
    bar->setUsesScrollButtons(true);
    bar->setExpanding(false);
    bar->setToolTip(tr("Panels that share this place; right-click to close one or to take it out"));
    bar->setAccessibleName(tr("Panels that share this place"));
    bar->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(bar, &QWidget::customContextMenuRequested, this,
            [this, bar](const QPoint& at) { showMenu(bar, at); });
    const auto tell = [this, bar](int index) {
        if (QDockWidget* dock = dockAt(bar, index)) emit chosen(dock);
    };
    connect(bar, &QTabBar::tabBarClicked, this, tell);
    connect(bar, &QTabBar::currentChanged, this, tell);
}

void DockTabs::showMenu(QTabBar* bar, const QPoint& at) {
    // The menu key asks for the present tab.
    const int under = bar->tabAt(at);
    QDockWidget* dock = dockAt(bar, under >= 0 ? under : bar->currentIndex());
    if (!dock) return;
    auto* menu = new QMenu(bar);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("&Take Out"), dock, [dock] { dock->setFloating(true); });
    menu->addAction(tr("&Close"), dock, &QWidget::close);
    menu->popup(bar->mapToGlobal(at));
}

}  // namespace isoscope
