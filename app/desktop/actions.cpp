// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/actions.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include "widgets/icons.h"

namespace isoscope {

Actions::Actions(QWidget* window) : QObject(window), window_(window) {
    addFileActions();
    addEditActions();
    addViewActions();
    addStudyActions();
    includeFolders = add(tr("&Include Folders…"), tr("Where #include looks besides the folder of the file"));
    shortcuts = add(tr("&Keyboard Shortcuts"), tr("All commands and their keys"), "input-keyboard",
                    QKeySequence::HelpContents);
    about = add(tr("&About Isoscope"), tr("Version and licence"), "help-about");
}

QAction* Actions::add(const QString& text, const QString& toolTip, const char* icon,
                      const QKeySequence& keys) {
    auto* action = new QAction(text, this);
    if (icon) action->setIcon(themeIcon(QLatin1String(icon)));
    action->setShortcut(keys);
    action->setToolTip(keys.isEmpty() ? toolTip
                                      : tr("%1 (%2)").arg(toolTip, keys.toString(QKeySequence::NativeText)));
    action->setStatusTip(toolTip);
    window_->addAction(action);
    all_ << action;
    return action;
}

QAction* Actions::addShown(const QString& text, const QString& toolTip, const char* icon,
                           const QKeySequence& keys) {
    QAction* action = add(text, toolTip, icon, keys);
    action->setShortcutContext(Qt::WidgetShortcut);
    return action;
}

void Actions::addFileActions() {
    newFile = add(tr("&New"), tr("Start with an empty scene"), "document-new", QKeySequence::New);
    open = add(tr("&Open…"), tr("Open a scene or include file"), "document-open", QKeySequence::Open);
    save = add(tr("&Save"), tr("Save the text"), "document-save", QKeySequence::Save);
    saveAs = add(tr("Save &As…"), tr("Save the text under another name"), "document-save-as",
                 Qt::CTRL | Qt::SHIFT | Qt::Key_S);
    copyIsosurface =
        add(tr("Copy &Isosurface"), tr("Copy the isosurface at the caret, with the declarations it needs"),
            "edit-copy", Qt::CTRL | Qt::SHIFT | Qt::Key_C);
    exportInclude =
        add(tr("Isosurface as &Include File…"),
            tr("Write the isosurface at the caret, with the declarations it needs, to an .inc file"));
    exportScene = add(tr("Complete &Scene for POV-Ray…"),
                      tr("Write a .pov file that POV-Ray renders to the picture of the viewport"));
    exportVirtualight = add(tr("Objects for &VirtuaLight…"),
                            tr("Write a .vl file of the objects that VirtuaLight's notation can say"));
    exportImage = add(tr("I&mage…"), tr("Render the view to a PNG file of any size"), "camera-photo",
                      Qt::CTRL | Qt::Key_E);
    quit = add(tr("&Quit"), tr("Close the window; unsaved text is kept for the next start"),
               "application-exit", QKeySequence::Quit);
    if (quit->shortcut().isEmpty()) quit->setShortcut(Qt::CTRL | Qt::Key_Q);
}

void Actions::addEditActions() {
    undo = add(tr("&Undo"), tr("Take back the last change; a drag of a slider is one change"), "edit-undo",
               QKeySequence::Undo);
    redo =
        add(tr("&Redo"), tr("Do again what was taken back"), "edit-redo", Qt::CTRL | Qt::SHIFT | Qt::Key_Z);
    cut = addShown(tr("Cu&t"), tr("Move the selected text to the clipboard"), "edit-cut", QKeySequence::Cut);
    copy =
        addShown(tr("&Copy"), tr("Copy the selected text to the clipboard"), "edit-copy", QKeySequence::Copy);
    paste = addShown(tr("&Paste"), tr("Insert the text of the clipboard"), "edit-paste", QKeySequence::Paste);
    selectAll =
        addShown(tr("Select &All"), tr("Select the whole text"), "edit-select-all", QKeySequence::SelectAll);
    find = add(tr("&Find…"), tr("Find in the text"), "edit-find", QKeySequence::Find);
    replace = add(tr("Find and R&eplace…"), tr("Find and replace in the text"), "edit-find-replace",
                  Qt::CTRL | Qt::Key_H);
    findNext = add(tr("Find &Next"), tr("Go to the next match"), "go-down-search", Qt::Key_F3);
    findPrevious =
        add(tr("Find Pre&vious"), tr("Go to the match before"), "go-up-search", Qt::SHIFT | Qt::Key_F3);
    comment = add(tr("To&ggle Comment"), tr("Turn the selected lines into comments, or back"), nullptr,
                  Qt::CTRL | Qt::Key_Slash);
    insertFunction = add(tr("&Function…"), tr("Search the built-in functions and insert one"), "list-add",
                         Qt::CTRL | Qt::Key_I);
}

void Actions::addViewActions() {
    resetView =
        add(tr("&Reset View"), tr("Go back to the camera of the text"), "go-home", Qt::CTRL | Qt::Key_0);
    writeView = add(tr("&Write View into Text"), tr("Make the present view the camera block of the text"),
                    "document-edit", Qt::CTRL | Qt::Key_K);
    redraw = add(tr("Re&draw"), tr("Render the picture again"), "view-refresh", QKeySequence::Refresh);
    stop = add(tr("&Stop"), tr("Stop the picture in the making"), "process-stop", Qt::SHIFT | Qt::Key_Escape);
    antialias = add(tr("&Smooth Edges"), tr("Render the resting picture with anti-aliasing; takes longer"),
                    "draw-bezier-curves");
    antialias->setCheckable(true);
    certified =
        add(tr("Ce&rtified"),
            tr("Show the surface as it is: no max_gradient, and no holes where the answer is proven"));
    povray = add(tr("P&OV-Ray"),
                 tr("Show what POV-Ray will show with the text's max_gradient and accuracy, holes included"));
    auto* finders = new QActionGroup(this);
    for (QAction* finder : {certified, povray}) {
        finder->setCheckable(true);
        finders->addAction(finder);
    }
    verdicts = add(tr("Show &Certainty"),
                   tr("Mark the pixels whose answer is not proven; for the certified root finder"), nullptr,
                   Qt::CTRL | Qt::Key_U);
    verdicts->setIconText(tr("Certainty"));
    verdicts->setCheckable(true);
    themeSystem = add(tr("&System"), tr("Light or dark as the desktop is"));
    themeLight = add(tr("&Light"), tr("Light colours"));
    themeDark = add(tr("&Dark"), tr("Dark colours"));
    auto* themes = new QActionGroup(this);
    for (QAction* theme : {themeSystem, themeLight, themeDark}) {
        theme->setCheckable(true);
        themes->addAction(theme);
    }
    resetLayout = add(tr("Reset &Layout"), tr("Put all panels back to their places"));
}

void Actions::addStudyActions() {
    overlayNone = add(tr("&None"), tr("Show the picture alone"));
    overlayNone->setIconText(tr("Overlay"));
    overlayHoles =
        add(tr("&Holes"), tr("Mark the pixels that POV-Ray's method loses, gains or finds at a wrong place"),
            nullptr, Qt::CTRL | Qt::Key_D);
    overlaySplit =
        add(tr("S&plit View"), tr("POV-Ray's picture left of a divider, the certified one right of it"));
    overlaySplit->setIconText(tr("Split"));
    overlayDifference =
        add(tr("&Difference Only"), tr("The pixels that POV-Ray's method gets wrong, without the picture"));
    overlayDifference->setIconText(tr("Difference"));
    overlayGradient =
        add(tr("&Gradient"), tr("The steepness of the function on the surface, measured by max_gradient"));
    auto* group = new QActionGroup(this);
    for (QAction* overlay : overlays()) {
        overlay->setCheckable(true);
        group->addAction(overlay);
    }
    overlayNone->setChecked(true);
    inspectRay =
        add(tr("Inspect &Ray"), tr("Click a pixel to see the function along its ray in the panel “Ray”"),
            nullptr, Qt::CTRL | Qt::Key_R);
    inspectRay->setIconText(tr("Ray"));
    inspectRay->setCheckable(true);
    sectionPlane =
        add(tr("Section &Plane"),
            tr("Show the plane of the cross-section in the picture; its square moves it, the ball turns it"),
            nullptr, Qt::CTRL | Qt::Key_L);
    sectionPlane->setIconText(tr("Plane"));
    sectionPlane->setCheckable(true);
}

QList<QAction*> Actions::overlays() const {
    return {overlayNone, overlayHoles, overlaySplit, overlayDifference, overlayGradient};
}

void Actions::fillMenuBar(QMenuBar* bar, QMenu* recent, QMenu* examples,
                          const QList<QAction*>& panels) const {
    QMenu* file = bar->addMenu(tr("&File"));
    file->addActions({newFile, open});
    recent->setTitle(tr("Open &Recent"));
    file->addMenu(recent);
    examples->setTitle(tr("Open E&xample"));
    file->addMenu(examples);
    file->addSeparator();
    file->addActions({save, saveAs});
    file->addSeparator();
    QMenu* exports = file->addMenu(themeIcon(QStringLiteral("document-export")), tr("&Export"));
    exports->addActions({copyIsosurface, exportInclude, exportScene, exportVirtualight, exportImage});
    file->addSeparator();
    file->addAction(quit);

    QMenu* edit = bar->addMenu(tr("&Edit"));
    edit->addActions({undo, redo});
    edit->addSeparator();
    edit->addActions({cut, copy, paste, selectAll});
    edit->addSeparator();
    edit->addActions({find, replace, findNext, findPrevious});
    edit->addSeparator();
    edit->addAction(comment);

    bar->addMenu(tr("&Insert"))->addAction(insertFunction);

    QMenu* view = bar->addMenu(tr("&View"));
    view->addActions({resetView, writeView});
    view->addSeparator();
    view->addActions({certified, povray, verdicts});
    view->addMenu(tr("&Overlay"))->addActions(overlays());
    view->addActions({inspectRay, sectionPlane});
    view->addSeparator();
    view->addActions({redraw, stop, antialias});
    view->addSeparator();
    view->addMenu(tr("&Panels"))->addActions(panels);
    view->addMenu(tr("&Theme"))->addActions({themeSystem, themeLight, themeDark});
    view->addAction(resetLayout);
    view->addSeparator();
    view->addAction(includeFolders);

    bar->addMenu(tr("&Help"))->addActions({shortcuts, about});
    for (QMenu* menu : bar->findChildren<QMenu*>()) menu->setToolTipsVisible(true);
}

void Actions::fillToolBar(QToolBar* bar) const {
    bar->addActions({newFile, open, save});
    bar->addSeparator();
    bar->addActions({undo, redo});
    bar->addSeparator();
    bar->addActions({insertFunction, find});
    bar->addSeparator();
    bar->addActions({copyIsosurface, exportImage});
}

void Actions::fillViewTools(QToolBar* bar) const {
    bar->addActions({resetView, writeView});
    bar->addSeparator();
    bar->addActions({antialias, redraw, stop});
    bar->addSeparator();
    bar->addActions({certified, povray});
    bar->addSeparator();
    bar->addAction(verdicts);
    auto* overlay = new QToolButton;
    overlay->setPopupMode(QToolButton::InstantPopup);
    overlay->setMenu(new QMenu(overlay));
    overlay->menu()->addActions(overlays());
    overlay->menu()->setToolTipsVisible(true);
    overlay->setToolTip(tr("What is laid over the picture: holes of POV-Ray's method, or the gradient"));
    overlay->setAccessibleName(tr("Overlay of the picture"));
    overlay->setText(overlayNone->iconText());
    // The button tells what is on, also when the menu bar chose it.
    for (QAction* choice : overlays())
        connect(choice, &QAction::toggled, overlay, [overlay, choice](bool on) {
            if (on) overlay->setText(choice->iconText());
        });
    bar->addWidget(overlay);
    bar->addActions({inspectRay, sectionPlane});
}

void Actions::fillContextMenu(QWidget* picture) const {
    picture->addActions({resetView, writeView, redraw, stop, antialias, certified, povray, verdicts,
                         inspectRay, sectionPlane, exportImage});
    picture->setContextMenuPolicy(Qt::ActionsContextMenu);
}

}  // namespace isoscope
