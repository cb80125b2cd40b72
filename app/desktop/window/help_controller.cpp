// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/help_controller.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QRegularExpression>
#include <QStringList>

#include "app/desktop/editing/insertion_controller.h"
#include "app/desktop/files/document_controller.h"
#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/functions/function_browser.h"
#include "widgets/help/help_browser.h"
#include "widgets/help/help_panel.h"
#include "widgets/parameters/parameter_slider.h"

namespace isoscope {
namespace {

const QString windowPage = QStringLiteral("help/window.md#");

/// The section about a panel, by the name of its dock.
QString panelAddress(const QString& dock) {
    if (dock == QLatin1String("editor")) return windowPage + QStringLiteral("text");
    if (dock == QLatin1String("section")) return windowPage + QStringLiteral("cross-section");
    return windowPage + dock;
}

}  // namespace

HelpController::HelpController(const Parts& parts, QObject* parent)
    : QObject(parent), parts_(parts), panel_(new HelpPanel) {
    dock_ = parts.docks->addLater({"help", tr("Help"),
                                   tr("<p>Lessons, and pages about the language, the functions and the "
                                      "window. F1 opens the one about what "
                                      "has the focus.</p>"),
                                   Docks::Place::right, panel_, true});
    connect(panel_, &HelpPanel::sceneRequested, this, &HelpController::openScene);
    connect(panel_, &HelpPanel::focusReleased, this, [this] {
        QWidget* back = focusBefore_ && focusBefore_->isVisible() ? focusBefore_.data() : parts_.editor;
        back->setFocus();
    });
    connect(panel_->browser(), &HelpBrowser::zoomRequested, this, [this](int steps) {
        (steps > 0 ? parts_.actions->largerText : parts_.actions->smallerText)->trigger();
    });
    connect(parts.editor, &QsciScintilla::SCN_ZOOM, this, &HelpController::followZoom);
    // In its first place it is closed, as it was before it was made.
    connect(parts.actions->resetLayout, &QAction::triggered, dock_, &QWidget::hide);
    followZoom();
}

void HelpController::followZoom() {
    panel_->browser()->setZoom(static_cast<int>(parts_.editor->SendScintilla(QsciScintilla::SCI_GETZOOM)));
}

HelpController::Topic HelpController::topicAtCaret() const {
    // A section or a page of its own begins with its word; other pages are searched for it.
    const auto isOwn = [](const QString& address) {
        return address.contains(QLatin1Char('#')) || address.startsWith(QLatin1String("function/"));
    };
    const QString word = parts_.editor->wordAtCaret();
    const QString address = panel_->library().addressOf(word);
    if (!address.isEmpty()) return {address, isOwn(address) ? QString() : word};
    // At a number it is about the setting or the function that the number belongs to.
    static const QRegularExpression apart(QStringLiteral("\\W+"));
    const QStringList before = parts_.editor->lineBeforeCaret().split(apart, Qt::SkipEmptyParts);
    for (auto one = before.crbegin(); one != before.crend(); ++one)
        if (const QString near = panel_->library().addressOf(*one); isOwn(near)) return {near, {}};
    return {};
}

HelpController::Topic HelpController::topicOf(const QWidget* focus) const {
    if (focus == parts_.editor) return topicAtCaret();
    for (const QWidget* widget = focus; widget; widget = widget->parentWidget()) {
        if (const auto* slider = qobject_cast<const ParameterSlider*>(widget)) {
            const QString address = panel_->library().addressOf(slider->name());
            if (!address.isEmpty()) return {address, {}};
        }
        if (widget == parts_.functions && parts_.functions->current()) {
            const QString name = QString::fromStdString(parts_.functions->current()->name);
            if (!name.isEmpty()) return {panel_->library().addressOf(name), {}};
        }
        if (widget == dock_) return {};
        if (const auto* dock = qobject_cast<const QDockWidget*>(widget))
            return {panelAddress(dock->objectName()), {}};
        if (widget == parts_.window->centralWidget()) return {panelAddress(QStringLiteral("picture")), {}};
    }
    return {};
}

void HelpController::showForFocus() { show(topicOf(QApplication::focusWidget())); }

void HelpController::showLessons() { show({HelpLibrary::index() + QStringLiteral("#lessons"), {}}); }

void HelpController::show(const Topic& topic) {
    QWidget* focus = QApplication::focusWidget();
    if (focus && !panel_->isAncestorOf(focus)) focusBefore_ = focus;
    parts_.docks->bringUp(dock_);
    panel_->open(topic.address.isEmpty() ? HelpLibrary::index() : topic.address, topic.words);
    panel_->browser()->setFocus();
}

void HelpController::openScene(const HelpScene& scene) {
    if (scene.composed) return parts_.documents->showLesson(scene.text, scene.title, scene.asPovray);
    parts_.documents->showText(scene.text, scene.title, [this] { parts_.insertions->fitNext(); });
}

}  // namespace isoscope
