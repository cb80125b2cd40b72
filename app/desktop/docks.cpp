// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/docks.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QTabBar>

namespace isoscope {

namespace {

constexpr int parameterWidth = 290;

}  // namespace

Docks::Docks(QMainWindow* window, const Contents& contents) : QObject(window), window_(window) {
    window->setDockNestingEnabled(true);
    window->setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    window->setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    window->setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    text = add(tr("Text"), "editor", contents.text, Qt::LeftDockWidgetArea);
    problems = add(tr("Problems"), "problems", contents.problems, Qt::LeftDockWidgetArea);
    parameters = add(tr("Parameters"), "parameters", contents.parameters, Qt::RightDockWidgetArea);
    functions = add(tr("Functions"), "functions", contents.functions, parameters);
    section = add(tr("Cross-section"), "section", contents.section, Qt::BottomDockWidgetArea);
    gradient = add(tr("Gradient"), "gradient", contents.gradient, section);
    histogram = add(tr("Histogram"), "histogram", contents.histogram, gradient);
    accuracy = add(tr("Accuracy"), "accuracy", contents.accuracy, histogram);
    ray = add(tr("Ray"), "ray", contents.ray, accuracy);
    effects = add(tr("Effects"), "effects", contents.effects, ray);
}

QList<QDockWidget*> Docks::all() const {
    return {text, problems, parameters, functions, section, gradient, histogram, accuracy, ray, effects};
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

void Docks::arrange() {
    window_->splitDockWidget(text, problems, Qt::Vertical);
    const QList<QDockWidget*> plots{section, gradient, histogram, accuracy, ray, effects};
    window_->tabifyDockWidget(parameters, functions);
    for (qsizetype i = 1; i < plots.size(); ++i) window_->tabifyDockWidget(plots[i - 1], plots[i]);
    for (QDockWidget* dock : all()) {
        dock->setFloating(false);
        dock->show();
    }
    parameters->raise();
    section->raise();
    for (QTabBar* tabs : window_->findChildren<QTabBar*>(Qt::FindDirectChildrenOnly)) {
        tabs->setToolTip(tr("Panels that share this place"));
        tabs->setAccessibleName(tr("Panels that share this place"));
    }
    const int width = window_->width(), height = window_->height();
    window_->resizeDocks({text, parameters}, {width / 3, parameterWidth}, Qt::Horizontal);
    window_->resizeDocks({text, problems}, {height * 5 / 6, height / 6}, Qt::Vertical);
    window_->resizeDocks({section}, {height * 36 / 100}, Qt::Vertical);
}

}  // namespace isoscope
