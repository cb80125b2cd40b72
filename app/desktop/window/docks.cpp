// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/docks.h"

#include <QAction>
#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QScrollArea>

#include "app/desktop/window/dock_tabs.h"

namespace isoscope {

namespace {

/// Holds a panel without asking how high it would be at its width: a scroll area would take that for the
/// least height of a panel with a line that wraps, and scroll charts that can be lower.
class Pane : public QWidget {
  public:
    explicit Pane(QWidget* content) : content_(content) { content->setParent(this); }

    QSize sizeHint() const override { return content_->sizeHint(); }
    QSize minimumSizeHint() const override { return content_->minimumSizeHint(); }

  protected:
    void resizeEvent(QResizeEvent*) override { content_->resize(size()); }
    bool event(QEvent* event) override {
        if (event->type() == QEvent::LayoutRequest) updateGeometry();
        return QWidget::event(event);
    }

  private:
    QWidget* content_;
};

/// What lies below the picture must not keep it small: a panel that is lower than it should be is scrolled.
QWidget* scrolled(QWidget* content) {
    auto* area = new QScrollArea;
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidget(new Pane(content));
    return area;
}

Qt::DockWidgetArea areaOf(Docks::Place place) {
    switch (place) {
        case Docks::Place::below: return Qt::BottomDockWidgetArea;
        case Docks::Place::right: return Qt::RightDockWidgetArea;
        default: return Qt::LeftDockWidgetArea;
    }
}

}  // namespace

Docks::Docks(QMainWindow* window, const QList<Row>& rows) : QObject(window), window_(window) {
    window->setDockNestingEnabled(true);
    window->setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    window->setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    window->setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    for (const Row& row : rows) add(row);
    tabs_ = new DockTabs(window, all());
}

void Docks::add(const Row& row) {
    auto* dock = new QDockWidget(row.title, window_);
    dock->setObjectName(QLatin1String(row.id));
    dock->setWidget(row.place == Place::below ? scrolled(row.content) : row.content);
    dock->setWhatsThis(row.help);
    dock->toggleViewAction()->setToolTip(tr("Show or hide the panel “%1”").arg(row.title));
    connect(dock->toggleViewAction(), &QAction::triggered, this, [this, dock](bool shown) {
        if (shown) bringUp(dock);
    });
    const QList<QDockWidget*> neighbours = at(row.place);
    // Never beside the others, not even at first: the window would be widened for that, and stay so.
    if (neighbours.isEmpty())
        window_->addDockWidget(areaOf(row.place), dock);
    else
        window_->tabifyDockWidget(neighbours.last(), dock);
    docks_.append({row.place, dock, row.closed});
}

QDockWidget* Docks::addLater(const Row& row) {
    add(row);
    QDockWidget* dock = docks_.last().dock;
    tabs_->add(dock);
    if (!window_->restoreDockWidget(dock))
        window_->resizeDocks({dock}, {row.content->sizeHint().width()}, Qt::Horizontal);
    return dock;
}

QDockWidget* Docks::find(const char* id) const {
    for (const auto& [place, dock, closed] : docks_)
        if (dock->objectName() == QLatin1String(id)) return dock;
    return nullptr;
}

QList<QDockWidget*> Docks::at(Place wanted) const {
    QList<QDockWidget*> found;
    for (const auto& [place, dock, closed] : docks_)
        if (place == wanted) found << dock;
    return found;
}

QList<QDockWidget*> Docks::all() const {
    QList<QDockWidget*> found;
    for (const auto& [place, dock, closed] : docks_) found << dock;
    return found;
}

QList<QAction*> Docks::actions() const {
    QList<QAction*> toggles;
    for (QDockWidget* dock : all()) toggles << dock->toggleViewAction();
    return toggles;
}

void Docks::bringUp(QDockWidget* dock) {
    dock->show();
    dock->raise();
    emit broughtUp(dock);
}

void Docks::arrange() {
    constexpr Place places[] = {Place::upperLeft, Place::lowerLeft, Place::below, Place::right};
    for (const Place place : places)
        if (!at(place).isEmpty()) window_->addDockWidget(areaOf(place), at(place).first());
    if (!at(Place::upperLeft).isEmpty() && !at(Place::lowerLeft).isEmpty())
        window_->splitDockWidget(at(Place::upperLeft).first(), at(Place::lowerLeft).first(), Qt::Vertical);
    for (const Place place : places) {
        const QList<QDockWidget*> sharing = at(place);
        for (qsizetype i = 1; i < sharing.size(); ++i) window_->tabifyDockWidget(sharing[i - 1], sharing[i]);
    }
    for (const auto& [place, dock, closed] : docks_) {
        dock->setFloating(false);
        dock->setVisible(!closed);
    }
    for (const Place place : places)
        if (at(place).size() > 1) at(place).first()->raise();
}

}  // namespace isoscope
