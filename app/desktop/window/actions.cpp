// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/actions.h"

#include <QAction>
#include <QActionGroup>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include "app/desktop/window/overlay_button.h"
#include "widgets/icons.h"
#include "widgets/interface_language.h"

namespace isoscope {

Actions::Actions(QWidget* window) : QObject(window), window_(window) {
    addFileActions();
    addEditActions();
    addViewActions();
    addTextSizes();
    addLanguages();
    addStudyActions();
    includeFolders = add(tr("Inc&lude Folders…"), tr("Where #include looks besides the folder of the file"));
    help =
        add(tr("&Help"), tr("Open the page about the word at the caret, or about the panel with the focus"),
            "help-contents", QKeySequence::HelpContents);
    lessons = add(tr("&Lessons"), tr("Open the list of short lessons about isosurfaces"));
    commands = add(tr("&Commands…"), tr("Find a command of the menus by words and run it"), "system-search",
                   Qt::CTRL | Qt::SHIFT | Qt::Key_P);
    shortcuts = add(tr("&Keyboard Shortcuts"), tr("All commands and their keys"), "input-keyboard",
                    Qt::CTRL | Qt::Key_F1);
    whatsThis = add(tr("&What Is This?"), tr("Click anything of the window to hear what it is"),
                    "help-contextual", QKeySequence::WhatsThis);
    about = add(tr("&About Isoscope"), tr("Version and licence"), "help-about");
    nameAll();
}

QAction* Actions::add(const QString& text, const QString& toolTip, const char* icon,
                      const QKeySequence& keys) {
    auto* action = new QAction(text, this);
    if (icon) action->setIcon(themeIcon(QLatin1String(icon)));
    action->setShortcut(keys);
    action->setToolTip(Actions::toolTip(toolTip, keys));
    action->setStatusTip(toolTip);
    action->setIconText(plainText(text));
    window_->addAction(action);
    all_ << action;
    return action;
}

QString Actions::plainText(const QString& text) {
    return withoutAccessKey(text).remove(QChar(0x2026)).trimmed();
}

QString Actions::toolTip(const QString& text, const QKeySequence& keys) {
    return keys.isEmpty() ? text : tr("%1 (%2)").arg(text, keys.toString(QKeySequence::NativeText));
}

void Actions::nameAll() {
    const std::pair<QAction*, const char*> names[] = {
        {newFile, "newFile"},
        {newWindow, "newWindow"},
        {open, "open"},
        {save, "save"},
        {saveAs, "saveAs"},
        {keptTexts, "keptTexts"},
        {quit, "quit"},
        {followFile, "followFile"},
        {liveUpdate, "liveUpdate"},
        {copyIsosurface, "copyIsosurface"},
        {copyDifference, "copyDifference"},
        {copyPicture, "copyPicture"},
        {exportInclude, "exportInclude"},
        {exportNote, "exportNote"},
        {exportScene, "exportScene"},
        {exportVirtualight, "exportVirtualight"},
        {exportImage, "exportImage"},
        {pictureQueue, "pictureQueue"},
        {exportMesh, "exportMesh"},
        {exportAnimation, "exportAnimation"},
        {exportFrames, "exportFrames"},
        {undo, "undo"},
        {redo, "redo"},
        {cut, "cut"},
        {copy, "copy"},
        {paste, "paste"},
        {selectAll, "selectAll"},
        {find, "find"},
        {replace, "replace"},
        {findNext, "findNext"},
        {findPrevious, "findPrevious"},
        {comment, "comment"},
        {adjustNumber, "adjustNumber"},
        {fitContainer, "fitContainer"},
        {insertFunction, "insertFunction"},
        {gallery, "gallery"},
        {startPage, "startPage"},
        {fitView, "fitView"},
        {frontView, "frontView"},
        {topView, "topView"},
        {sideView, "sideView"},
        {resetView, "resetView"},
        {writeView, "writeView"},
        {redraw, "redraw"},
        {stop, "stop"},
        {antialias, "antialias"},
        {certified, "certified"},
        {povray, "povray"},
        {verdicts, "verdicts"},
        {overlayNone, "overlayNone"},
        {overlayHoles, "overlayHoles"},
        {overlaySplit, "overlaySplit"},
        {overlayDifference, "overlayDifference"},
        {overlayGradient, "overlayGradient"},
        {overlayCost, "overlayCost"},
        {overlayCompare, "overlayCompare"},
        {overlayPovray, "overlayPovray"},
        {overlayPovrayDifference, "overlayPovrayDifference"},
        {inspectRay, "inspectRay"},
        {sectionPlane, "sectionPlane"},
        {showContainers, "showContainers"},
        {showAxes, "showAxes"},
        {showCuts, "showCuts"},
        {themeSystem, "themeSystem"},
        {themeLight, "themeLight"},
        {themeDark, "themeDark"},
        {themeHighContrast, "themeHighContrast"},
        {wordWrap, "wordWrap"},
        {resetLayout, "resetLayout"},
        {includeFolders, "includeFolders"},
        {largerText, "largerText"},
        {smallerText, "smallerText"},
        {normalText, "normalText"},
        {nextPane, "nextPane"},
        {previousPane, "previousPane"},
        {help, "help"},
        {lessons, "lessons"},
        {commands, "commands"},
        {shortcuts, "shortcuts"},
        {whatsThis, "whatsThis"},
        {about, "about"},
    };
    for (const auto& [action, name] : names) action->setObjectName(QLatin1String(name));
    for (QAction* size : interfaceSizes)
        size->setObjectName(QStringLiteral("interfaceSize%1").arg(size->data().toInt()));
    for (QAction* language : languages)
        language->setObjectName(QStringLiteral("language-") + language->data().toString());
}

void Actions::addFileActions() {
    newFile = add(tr("&New"), tr("Start with an empty scene"), "document-new", QKeySequence::New);
    newWindow = add(tr("New &Window"), tr("Open another window with a document of its own"), "window-new",
                    Qt::CTRL | Qt::SHIFT | Qt::Key_N);
    open = add(tr("&Open…"), tr("Open a scene or include file"), "document-open", QKeySequence::Open);
    startPage = add(tr("Start Pa&ge"), tr("Choose a scene to begin with, by its picture"), "go-home");
    save = add(tr("&Save"), tr("Save the text"), "document-save", QKeySequence::Save);
    saveAs = add(tr("Save &As…"), tr("Save the text under another name"), "document-save-as",
                 Qt::CTRL | Qt::SHIFT | Qt::Key_S);
    keptTexts = add(tr("&Kept Texts…"), tr("List the texts that were kept because they were not saved"));
    followFile =
        add(tr("Fo&llow Another Editor"),
            tr("Take over what another program saves to the file, while the text has no changes here"));
    followFile->setCheckable(true);
    copyIsosurface =
        add(tr("Copy &Isosurface"), tr("Copy the isosurface at the caret, with the declarations it needs"),
            "edit-copy", Qt::CTRL | Qt::SHIFT | Qt::Key_C);
    copyPicture = add(tr("Cop&y Picture"),
                      tr("Copy the picture as it is shown; Ctrl and the mouse drag it out of the window"),
                      "edit-copy", Qt::CTRL | Qt::ALT | Qt::Key_C);
    copyDifference = add(tr("Copy &Difference Surface"),
                         tr("Copy the isosurface that is 0 where the kept function and the present one agree "
                            "(View, Overlay, Compare A/B)"));
    copyDifference->setEnabled(false);
    exportInclude =
        add(tr("Isosurface as Include &File…"),
            tr("Write the isosurface at the caret, with the declarations it needs, to an .inc file"));
    exportNote =
        add(tr("&Comment of What Is Proven"),
            tr("Put a comment in front of isosurfaces that states the proven bound, method, view and "
               "version; it is checked when the text is opened again"));
    exportNote->setCheckable(true);
    exportScene = add(tr("Complete &Scene for POV-Ray…"),
                      tr("Write a .pov file that POV-Ray renders to the picture of the viewport"));
    exportVirtualight = add(tr("Objects for &VirtuaLight…"),
                            tr("Write a .vl file of the objects that VirtuaLight's notation can say"));
    exportImage = add(tr("I&mage…"), tr("Render the view to a PNG or OpenEXR file of any size"),
                      "camera-photo", Qt::CTRL | Qt::Key_E);
    pictureQueue = add(tr("Pictures in the Ma&king…"),
                       tr("List the images that are being rendered, and stop them"), "view-list-details");
    exportAnimation =
        add(tr("&Animation for POV-Ray…"),
            tr("Write a .pov file whose numbers follow clock as the timeline has them, and its .ini file"));
    exportFrames =
        add(tr("F&rames and Film…"),
            tr("Draw the frames of the timeline into pictures, and a film where ffmpeg is installed"));
    exportMesh =
        add(tr("M&esh…"), tr("Write the isosurfaces as triangles: STL, 3MF, OBJ, PLY, glTF, or for POV-Ray"),
            "document-export");
    quit = add(tr("&Quit"), tr("Close the window; unsaved text is kept for the next start"),
               "application-exit", QKeySequence::Quit);
    if (quit->shortcut().isEmpty()) quit->setShortcut(Qt::CTRL | Qt::Key_Q);
}

void Actions::addEditActions() {
    undo = add(tr("&Undo"), tr("Take back the last change; a drag of a slider is one change"), "edit-undo",
               QKeySequence::Undo);
    redo =
        add(tr("&Redo"), tr("Do again what was taken back"), "edit-redo", Qt::CTRL | Qt::SHIFT | Qt::Key_Z);
    cut = add(tr("Cu&t"), tr("Move the selected text to the clipboard"), "edit-cut", QKeySequence::Cut);
    copy = add(tr("&Copy"), tr("Copy the selected text to the clipboard"), "edit-copy", QKeySequence::Copy);
    paste = add(tr("&Paste"), tr("Insert the text of the clipboard"), "edit-paste", QKeySequence::Paste);
    // As X11 and Windows have always had them.
    cut->setShortcuts({cut->shortcut(), Qt::SHIFT | Qt::Key_Delete});
    copy->setShortcuts({copy->shortcut(), Qt::CTRL | Qt::Key_Insert});
    paste->setShortcuts({paste->shortcut(), Qt::SHIFT | Qt::Key_Insert});
    redo->setShortcuts({redo->shortcut(), Qt::CTRL | Qt::Key_Y});
    selectAll =
        add(tr("Select &All"), tr("Select the whole text"), "edit-select-all", QKeySequence::SelectAll);
    find = add(tr("&Find…"), tr("Find in the text"), "edit-find", QKeySequence::Find);
    replace = add(tr("Find and R&eplace…"), tr("Find and replace in the text"), "edit-find-replace",
                  Qt::CTRL | Qt::Key_H);
    findNext = add(tr("Find &Next"), tr("Go to the next match"), "go-down-search", Qt::Key_F3);
    findPrevious =
        add(tr("Find Pre&vious"), tr("Go to the match before"), "go-up-search", Qt::SHIFT | Qt::Key_F3);
    comment = add(tr("To&ggle Comment"), tr("Turn the selected lines into comments, or back"), nullptr,
                  Qt::CTRL | Qt::Key_Slash);
    adjustNumber =
        add(tr("Ad&just Number…"), tr("Open a slider for the number at the caret"), nullptr, Qt::Key_F2);
    fitContainer = add(tr("F&it Container"),
                       tr("Give the isosurface at the caret the smallest container that is proven to show "
                          "the same; POV-Ray looks for roots only inside"),
                       "zoom-fit-drawing");
    insertFunction = add(tr("&Function…"), tr("Search the built-in functions and insert one"), "list-add",
                         Qt::CTRL | Qt::Key_I);
}

void Actions::addViewActions() {
    fitView = add(tr("&Fit View"), tr("Show everything that is there, whole; F alone does it in the picture"),
                  "zoom-fit-best", Qt::CTRL | Qt::SHIFT | Qt::Key_F);
    frontView = add(tr("From the F&ront"), tr("Look at everything from the front"));
    topView = add(tr("From A&bove"), tr("Look at everything from above"));
    sideView = add(tr("From the Rig&ht"), tr("Look at everything from the right side"));
    resetView = add(tr("&As the Text Says"), tr("Go back to the camera of the text"), "go-home",
                    Qt::CTRL | Qt::SHIFT | Qt::Key_R);
    writeView = add(tr("&Write View into Text"), tr("Make the present view the camera block of the text"),
                    "document-edit", Qt::CTRL | Qt::Key_K);
    redraw = add(tr("Re&draw"), tr("Render the picture again"), "view-refresh", QKeySequence::Refresh);
    liveUpdate = add(tr("Update W&hile Typing"),
                     tr("Show what is typed after a moment; else when it is saved, or on Redraw"));
    liveUpdate->setCheckable(true);
    stop = add(tr("&Stop"), tr("Stop the picture in the making"), "process-stop", Qt::SHIFT | Qt::Key_Escape);
    antialias = add(tr("S&mooth Edges"), tr("Render the resting picture with anti-aliasing; takes longer"),
                    "draw-bezier-curves");
    antialias->setCheckable(true);
    certified = add(tr("E&xact"),
                    tr("Show the surface as it is, without holes; the certified root finder proves it"));
    povray =
        add(tr("As PO&V-Ray"),
            tr("Show what POV-Ray will draw, holes included, with the text's max_gradient and accuracy"));
    auto* finders = new QActionGroup(this);
    for (QAction* finder : {certified, povray}) {
        finder->setCheckable(true);
        finders->addAction(finder);
    }
    showContainers =
        add(tr("Containe&r Outlines"), tr("Draw the containers of the isosurfaces over the picture"),
            "snap-bounding-box-edges", Qt::CTRL | Qt::SHIFT | Qt::Key_B);
    showContainers->setIconText(tr("Container"));
    showAxes = add(tr("Ax&es"), tr("Draw the axes of the scene, and how the view is turned"),
                   "labplot-xy-plot-two-axes", Qt::CTRL | Qt::SHIFT | Qt::Key_A);
    showCuts =
        add(tr("&Cut Faces"),
            tr("Hatch where a container cuts its isosurface; that face is no surface of the function"));
    for (QAction* guide : {showContainers, showAxes, showCuts}) guide->setCheckable(true);
    verdicts = add(tr("Show &Unproven Pixels"),
                   tr("Mark the pixels of the exact picture that are not proven to be right"), "help-hint",
                   Qt::CTRL | Qt::Key_U);
    verdicts->setIconText(tr("Unproven"));
    verdicts->setCheckable(true);
    themeSystem = add(tr("&System"), tr("Light or dark as the desktop is"));
    themeLight = add(tr("&Light"), tr("Light colours"));
    themeDark = add(tr("&Dark"), tr("Dark colours"));
    themeHighContrast = add(tr("High &Contrast"), tr("White on black, with outlines; text of at least 7:1"));
    auto* themes = new QActionGroup(this);
    for (QAction* theme : {themeSystem, themeLight, themeDark, themeHighContrast}) {
        theme->setCheckable(true);
        themes->addAction(theme);
    }
    wordWrap = add(tr("Wrap Lon&g Lines"),
                   tr("Continue lines of the text that are too long for its panel on the next row"));
    wordWrap->setCheckable(true);
    gallery =
        add(tr("&Browse Gallery"), tr("Choose among functions, examples and your own scenes, with pictures"),
            "view-grid", Qt::CTRL | Qt::SHIFT | Qt::Key_G);
    nextPane =
        add(tr("Ne&xt Panel"), tr("Go to the next of panels, picture and tool bars"), nullptr, Qt::Key_F6);
    previousPane = add(tr("Pre&vious Panel"), tr("Go to the one before of panels, picture and tool bars"),
                       nullptr, Qt::SHIFT | Qt::Key_F6);
    resetLayout = add(tr("Reset La&yout"), tr("Put all panels back to their places"));
}

void Actions::addTextSizes() {
    largerText = add(tr("&Larger"), tr("Larger letters in the text"), "zoom-in", Qt::CTRL | Qt::Key_Plus);
    // Where plus needs Shift, the key says "=" without it.
    largerText->setShortcuts({largerText->shortcut(), Qt::CTRL | Qt::Key_Equal});
    smallerText =
        add(tr("&Smaller"), tr("Smaller letters in the text"), "zoom-out", Qt::CTRL | Qt::Key_Minus);
    normalText = add(tr("&Normal"), tr("Letters of the usual size"), "zoom-original", Qt::CTRL | Qt::Key_0);
    auto* sizes = new QActionGroup(this);
    for (const int percent : {100, 125, 150, 175, 200}) {
        QAction* size = add(
            tr("Everything at %1 %").arg(percent),
            tr("Letters, icons and marks of the whole window at %1 % of the desktop's size").arg(percent));
        size->setCheckable(true);
        size->setData(percent);
        sizes->addAction(size);
        interfaceSizes << size;
    }
}

void Actions::addLanguages() {
    auto* group = new QActionGroup(this);
    const auto addLanguage = [&](const QString& code, const QString& name) {
        QAction* language = add(name, tr("Texts of the window in this language, from the next start on"));
        language->setCheckable(true);
        language->setData(code);
        group->addAction(language);
        languages << language;
    };
    addLanguage({}, tr("&The System's Language"));
    for (const InterfaceLanguage& language : interfaceLanguages()) addLanguage(language.code, language.name);
}

void Actions::addStudyActions() {
    overlayNone = add(tr("&None"), tr("Show the picture alone"));
    overlayNone->setIconText(tr("Overlay"));
    overlayHoles =
        add(tr("&Holes"),
            tr("Mark the holes of POV-Ray's picture: pixels lost, gained or found at a wrong place"), nullptr,
            Qt::CTRL | Qt::Key_D);
    overlaySplit =
        add(tr("S&plit View"), tr("POV-Ray's picture left of a divider, the exact one right of it"));
    overlaySplit->setIconText(tr("Split"));
    overlayDifference =
        add(tr("&Difference Only"), tr("What POV-Ray's picture gets wrong, without the picture"));
    overlayDifference->setIconText(tr("Difference"));
    overlayGradient =
        add(tr("&Gradient"), tr("How steep the function is on the surface, as a share of max_gradient"));
    overlayCost = add(tr("C&ost"),
                      tr("What each pixel takes in evaluations of the function, in the colour of its cause"));
    overlayPovray = add(
        tr("&Beside POV-Ray Itself"),
        tr("Have the installed POV-Ray draw the text: its picture left of a divider, the exact one right"));
    overlayPovray->setIconText(tr("POV-Ray"));
    overlayPovrayDifference =
        add(tr("Difference &from POV-Ray Itself"),
            tr("Have the installed POV-Ray draw the text, and mark what differs, by cause"));
    overlayPovrayDifference->setIconText(tr("Differs"));
    overlayCompare =
        add(tr("&Compare A/B"),
            tr("Keep the scene as it is now, and show it left of a divider while you change it"));
    overlayCompare->setIconText(tr("Compare"));
    auto* group = new QActionGroup(this);
    for (QAction* overlay : overlays()) {
        overlay->setCheckable(true);
        group->addAction(overlay);
    }
    overlayNone->setChecked(true);
    inspectRay =
        add(tr("&Inspect Ray"), tr("Click a pixel to see the function along its ray in the panel “Ray”"),
            "crosshairs", Qt::CTRL | Qt::Key_R);
    inspectRay->setIconText(tr("Ray"));
    inspectRay->setCheckable(true);
    sectionPlane =
        add(tr("Section &Plane"),
            tr("Show the plane of the cross-section in the picture; its square moves it, the ball turns it"),
            "path-clip-edit", Qt::CTRL | Qt::Key_L);
    sectionPlane->setIconText(tr("Plane"));
    sectionPlane->setCheckable(true);
}

QList<QAction*> Actions::overlays() const {
    return {overlayNone, overlayHoles,   overlaySplit,  overlayDifference,      overlayGradient,
            overlayCost, overlayCompare, overlayPovray, overlayPovrayDifference};
}

void Actions::fillMenuBar(QMenuBar* bar, QMenu* recent, QMenu* examples,
                          const QList<QAction*>& panels) const {
    QMenu* file = bar->addMenu(tr("&File"));
    file->addActions({newFile, newWindow, open});
    recent->setTitle(tr("Open &Recent"));
    file->addMenu(recent);
    examples->setTitle(tr("Open E&xample"));
    file->addMenu(examples);
    file->addAction(startPage);
    file->addSeparator();
    file->addActions({save, saveAs, followFile, keptTexts});
    file->addSeparator();
    QMenu* exports = file->addMenu(themeIcon(QStringLiteral("document-export")), tr("&Export"));
    exports->addActions({copyIsosurface, copyDifference, copyPicture, exportInclude, exportNote, exportScene,
                         exportVirtualight, exportImage, pictureQueue, exportMesh});
    exports->addSeparator();
    exports->addActions({exportAnimation, exportFrames});
    file->addSeparator();
    file->addAction(quit);

    QMenu* edit = bar->addMenu(tr("&Edit"));
    edit->addActions({undo, redo});
    edit->addSeparator();
    edit->addActions({cut, copy, copyPicture, paste, selectAll});
    edit->addSeparator();
    edit->addActions({find, replace, findNext, findPrevious});
    edit->addSeparator();
    edit->addActions({comment, adjustNumber, fitContainer});

    bar->addMenu(tr("&Insert"))->addAction(insertFunction);

    QMenu* view = bar->addMenu(tr("&View"));
    view->addAction(fitView);
    view->addMenu(tr("Loo&k"))->addActions({frontView, topView, sideView});
    view->addActions({resetView, writeView});
    view->addSeparator();
    view->addActions({certified, povray, verdicts});
    view->addMenu(tr("&Overlay"))->addActions(overlays());
    view->addActions({inspectRay, sectionPlane});
    view->addActions({showContainers, showAxes, showCuts});
    view->addSeparator();
    view->addActions({liveUpdate, redraw, stop, antialias});
    view->addSeparator();
    view->addAction(gallery);
    QMenu* shown = view->addMenu(tr("Pa&nels"));
    shown->addActions(panels);
    shown->addSeparator();
    shown->addActions({nextPane, previousPane});
    view->addMenu(tr("&Theme"))->addActions({themeSystem, themeLight, themeDark, themeHighContrast});
    QMenu* sizes = view->addMenu(tr("Text Si&ze"));
    sizes->addActions({largerText, smallerText, normalText});
    sizes->addSeparator();
    sizes->addActions(interfaceSizes);
    view->addMenu(tr("Language"))->addActions(languages);
    view->addActions({wordWrap, resetLayout});
    view->addSeparator();
    view->addAction(includeFolders);

    bar->addMenu(tr("&Help"))->addActions({help, lessons, startPage, commands, shortcuts, whatsThis, about});
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

QList<QToolButton*> Actions::fillViewTools(QToolBar* bar) const {
    bar->addActions({fitView, resetView, writeView});
    bar->addSeparator();
    bar->addActions({antialias, redraw, stop});
    bar->addSeparator();
    bar->addActions({certified, povray});
    bar->addSeparator();
    auto* heading = new QLabel(tr("Show:"));
    heading->setContentsMargins(4, 0, 4, 0);
    bar->addWidget(heading);
    auto* overlay = new OverlayButton(overlays());
    bar->addWidget(overlay);
    QList<QToolButton*> worded{overlay};
    for (QAction* action : {verdicts, inspectRay, sectionPlane, showContainers, showAxes}) {
        bar->addAction(action);
        if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action))) worded << button;
    }
    return worded;
}

void Actions::fillContextMenu(QWidget* picture) const {
    picture->addActions({fitView, resetView, writeView, redraw, stop, antialias, certified, povray, verdicts,
                         inspectRay, sectionPlane, copyPicture, exportImage});
    // Not Qt's menu of actions: that one runs an event loop of its own.
    picture->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(picture, &QWidget::customContextMenuRequested, picture, [picture](QPoint at) {
        auto* menu = new QMenu(picture);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        menu->addActions(picture->actions());
        menu->popup(picture->mapToGlobal(at));
    });
}

}  // namespace isoscope
