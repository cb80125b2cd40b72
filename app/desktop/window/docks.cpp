// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/docks.h"

#include <QAction>
#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QScrollArea>

#include "app/desktop/studies/study_panels.h"
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

}  // namespace

Docks::Docks(QMainWindow* window, const Contents& contents) : QObject(window), window_(window) {
    window->setDockNestingEnabled(true);
    window->setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    window->setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    window->setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    text = add(tr("Text"), "editor", contents.text, Qt::LeftDockWidgetArea);
    parameters = add(tr("Parameters"), "parameters", contents.parameters, Qt::LeftDockWidgetArea);
    functions = add(tr("Functions"), "functions", contents.functions, parameters);
    problems = add(tr("Problems"), "problems", contents.problems, functions);
    for (const StudyPanels::Entry& entry : contents.studies.entries()) {
        QWidget* content = scrolled(entry.panel);
        studies << (studies.isEmpty() ? add(entry.title, entry.id, content, Qt::BottomDockWidgetArea)
                                      : add(entry.title, entry.id, content, studies.last()));
        studies.last()->setWhatsThis(entry.help);
    }
    section = study("section");
    gradient = study("gradient");
    histogram = study("histogram");
    accuracy = study("accuracy");
    ray = study("ray");
    effects = study("effects");
    tabs_ = new DockTabs(window, all());
}

QDockWidget* Docks::study(const char* id) const {
    for (QDockWidget* dock : studies)
        if (dock->objectName() == QLatin1String(id)) return dock;
    return nullptr;
}

QList<QDockWidget*> Docks::all() const {
    return QList<QDockWidget*>{text, parameters, functions, problems} + studies;
}

QDockWidget* Docks::make(const QString& title, const char* name, QWidget* content) {
    auto* dock = new QDockWidget(title, window_);
    dock->setObjectName(QLatin1String(name));
    dock->setWidget(content);
    dock->toggleViewAction()->setToolTip(tr("Show or hide the panel “%1”").arg(title));
    return dock;
}

QDockWidget* Docks::add(const QString& title, const char* name, QWidget* content, Qt::DockWidgetArea area) {
    QDockWidget* dock = make(title, name, content);
    window_->addDockWidget(area, dock);
    return dock;
}

QDockWidget* Docks::add(const QString& title, const char* name, QWidget* content, QDockWidget* below) {
    QDockWidget* dock = make(title, name, content);
    // Never beside the others, not even at first: the window would be widened for that, and stay so.
    window_->tabifyDockWidget(below, dock);
    return dock;
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
    for (QDockWidget* dock : {text, parameters}) window_->addDockWidget(Qt::LeftDockWidgetArea, dock);
    window_->addDockWidget(Qt::BottomDockWidgetArea, studies.first());
    window_->splitDockWidget(text, parameters, Qt::Vertical);
    window_->tabifyDockWidget(parameters, functions);
    window_->tabifyDockWidget(functions, problems);
    for (qsizetype i = 1; i < studies.size(); ++i) window_->tabifyDockWidget(studies[i - 1], studies[i]);
    for (QDockWidget* dock : all()) {
        dock->setFloating(false);
        dock->show();
    }
    parameters->raise();
    studies.first()->raise();
}

}  // namespace isoscope
