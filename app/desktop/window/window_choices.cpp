// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/window_choices.h"

#include <QAction>
#include <QMainWindow>
#include <QSettings>

#include "app/desktop/window/actions.h"
#include "app/desktop/window/picture_room.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/interface_language.h"
#include "widgets/interface_style.h"
#include "widgets/viewport/scene_guides.h"
#include "widgets/viewport/viewport.h"

namespace isoscope {

namespace {

constexpr QSize smallestFirstSize{1280, 800};
constexpr QSize largestFirstSize{1800, 1120};
constexpr QSize roomOfFrame{8, 40};
constexpr double shareOfScreen = 0.85;
/// Raised when panels come or go. What a person has arranged in an earlier version is taken over; panels that
/// it does not know stay where they are at first.
constexpr int layoutVersion = 9;
const QString geometryKey = QStringLiteral("window/geometry");
const QString layoutKey = QStringLiteral("window/layout");
const QString roomKey = QStringLiteral("window/room");
const QString themeKey = QStringLiteral("window/theme");
const QString interfaceSizeKey = QStringLiteral("window/interfaceSize");
const QString rootFinderKey = QStringLiteral("view/rootFinder");
const QString certifiedName = QStringLiteral("certified");
const QString povrayName = QStringLiteral("povray");
const QString movingSecondsKey = QStringLiteral("view/movingSeconds");
constexpr double defaultMovingSeconds = 0.4;
const QString antialiasKey = QStringLiteral("view/antialias");
/// Seconds; smooth edges take about as long again.
constexpr double quickPicture = 2;
const QString containersKey = QStringLiteral("view/containers");
const QString axesKey = QStringLiteral("view/axes");
const QString cutsKey = QStringLiteral("view/cuts");
const QString wordWrapKey = QStringLiteral("text/wordWrap");
const QString liveUpdateKey = QStringLiteral("text/updateWhileTyping");
const QString followFileKey = QStringLiteral("text/followAnotherEditor");
const QString exportNoteKey = QStringLiteral("export/comment");

}  // namespace

WindowChoices::WindowChoices(const Parts& parts)
    : QObject(parts.window), parts_(parts), factoryLayout_(parts.window->saveState(layoutVersion)) {
    connectActions();
}

void WindowChoices::connectActions() {
    const Actions& actions = *parts_.actions;
    const auto on = [this](QAction* action, auto method) {
        connect(action, &QAction::triggered, this, method);
    };
    on(actions.themeSystem, [this] { chooseTheme(Theme::system); });
    on(actions.themeLight, [this] { chooseTheme(Theme::light); });
    on(actions.themeDark, [this] { chooseTheme(Theme::dark); });
    on(actions.themeHighContrast, [this] { chooseTheme(Theme::highContrast); });
    for (QAction* size : actions.interfaceSizes) {
        size->setChecked(size->data().toInt() == interfaceSize());
        on(size, [this, size] { chooseInterfaceSize(size->data().toInt()); });
    }
    for (QAction* language : actions.languages) {
        language->setChecked(language->data().toString() == chosenInterfaceLanguage());
        on(language, [language] { chooseInterfaceLanguage(language->data().toString()); });
    }
    on(actions.certified, [this] { chooseRootFinder(RootFinder::certified); });
    on(actions.povray, [this] { chooseRootFinder(RootFinder::lipschitz); });
    // Stored only when it was chosen; else pictures that come quickly get smooth edges by themselves.
    on(actions.antialias, [this](bool wanted) {
        QSettings().setValue(antialiasKey, wanted);
        parts_.viewport->setAntialias(wanted);
    });
    connect(actions.showContainers, &QAction::triggered, &parts_.viewport->guides(),
            &SceneGuides::setContainersShown);
    connect(actions.showAxes, &QAction::triggered, &parts_.viewport->guides(), &SceneGuides::setAxesShown);
    connect(actions.showCuts, &QAction::triggered, parts_.viewport, &Viewport::setCutsShown);
    connect(actions.wordWrap, &QAction::triggered, parts_.editor, &SceneEditor::setWordWrap);
    on(actions.resetLayout, [this] {
        parts_.window->restoreState(factoryLayout_, layoutVersion);
        parts_.room->reset();
    });
}

QSize WindowChoices::firstSize(QSize available) {
    const QSize wanted = (QSizeF(available) * shareOfScreen).toSize();
    // Of the smallest, too, only what the screen has room for, beside the frame that the desktop adds.
    return wanted.expandedTo(smallestFirstSize)
        .boundedTo(largestFirstSize)
        .boundedTo(available - roomOfFrame);
}

void WindowChoices::applyStoredLook() {
    applyInterfaceLanguage();
    const QSettings settings;
    setInterfaceSize(settings.value(interfaceSizeKey, usualInterfaceSize).toInt());
    applyTheme(themeFromName(settings.value(themeKey).toString()));
}

void WindowChoices::read() {
    const QSettings settings;
    parts_.window->restoreGeometry(settings.value(geometryKey).toByteArray());
    const QByteArray layout = settings.value(layoutKey).toByteArray();
    for (int version = layoutVersion; version > 0; --version)
        if (parts_.window->restoreState(layout, version)) break;
    parts_.room->setChoices(settings.value(roomKey).toString());
    setTheme(themeFromName(settings.value(themeKey).toString()));
    readPicture();
    QAction* wordWrap = parts_.actions->wordWrap;
    wordWrap->setChecked(settings.value(wordWrapKey, true).toBool());
    parts_.editor->setWordWrap(wordWrap->isChecked());
    // Unchecked at first: the change is told.
    parts_.actions->liveUpdate->setChecked(true);
    parts_.actions->liveUpdate->setChecked(settings.value(liveUpdateKey, true).toBool());
    parts_.actions->followFile->setChecked(settings.value(followFileKey, false).toBool());
    parts_.actions->exportNote->setChecked(settings.value(exportNoteKey, false).toBool());
}

void WindowChoices::readPicture() {
    const QSettings settings;
    const Actions& actions = *parts_.actions;
    const QVariant smooth = settings.value(antialiasKey);
    actions.antialias->setChecked(smooth.isValid() ? smooth.toBool() : true);
    parts_.viewport->setAntialias(actions.antialias->isChecked(),
                                  smooth.isValid() ? Viewport::anyTime : quickPicture);
    const auto readGuide = [&settings](QAction* action, const QString& key, bool usual) {
        if (settings.value(key, usual).toBool() != action->isChecked()) action->trigger();
    };
    readGuide(actions.showContainers, containersKey, false);
    readGuide(actions.showAxes, axesKey, false);
    readGuide(actions.showCuts, cutsKey, true);
    parts_.viewport->setMovingSeconds(settings.value(movingSecondsKey, defaultMovingSeconds).toDouble());
    restoreRootFinder();
}

void WindowChoices::write() const {
    QSettings settings;
    settings.setValue(geometryKey, parts_.window->saveGeometry());
    settings.setValue(layoutKey, parts_.window->saveState(layoutVersion));
    settings.setValue(roomKey, parts_.room->choices());
    settings.setValue(containersKey, parts_.actions->showContainers->isChecked());
    settings.setValue(axesKey, parts_.actions->showAxes->isChecked());
    settings.setValue(cutsKey, parts_.actions->showCuts->isChecked());
    settings.setValue(wordWrapKey, parts_.actions->wordWrap->isChecked());
    settings.setValue(liveUpdateKey, parts_.actions->liveUpdate->isChecked());
    settings.setValue(followFileKey, parts_.actions->followFile->isChecked());
    settings.setValue(exportNoteKey, parts_.actions->exportNote->isChecked());
    settings.setValue(movingSecondsKey, parts_.viewport->movingSeconds());
}

void WindowChoices::chooseTheme(Theme theme) {
    QSettings().setValue(themeKey, themeName(theme));
    setTheme(theme);
}

void WindowChoices::chooseInterfaceSize(int percent) {
    QSettings().setValue(interfaceSizeKey, percent);
    setInterfaceSize(percent);
}

void WindowChoices::setTheme(Theme theme) {
    applyTheme(theme);
    parts_.editor->applyTheme(lookOf(theme));
    parts_.actions->themeSystem->setChecked(theme == Theme::system);
    parts_.actions->themeLight->setChecked(theme == Theme::light);
    parts_.actions->themeDark->setChecked(theme == Theme::dark);
    parts_.actions->themeHighContrast->setChecked(theme == Theme::highContrast);
}

void WindowChoices::setRootFinder(RootFinder finder) {
    const bool certified = finder == RootFinder::certified;
    (certified ? parts_.actions->certified : parts_.actions->povray)->setChecked(true);
    // The other one tells nothing.
    parts_.actions->verdicts->setEnabled(certified);
    parts_.viewport->setRootFinder(finder);
}

void WindowChoices::restoreRootFinder() {
    const QString finder = QSettings().value(rootFinderKey).toString();
    setRootFinder(finder == certifiedName ? RootFinder::certified
                  : finder == povrayName  ? RootFinder::lipschitz
                                          : Viewport::defaultRootFinder);
}

void WindowChoices::chooseRootFinder(RootFinder finder) {
    // Stored only when it was chosen, so that a better default reaches everybody else.
    QSettings().setValue(rootFinderKey, finder == RootFinder::certified ? certifiedName : povrayName);
    setRootFinder(finder);
}

}  // namespace isoscope
