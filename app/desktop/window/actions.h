// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QList>
#include <QMap>
#include <QObject>

class QAction;
class QActionGroup;
class QMenu;
class QMenuBar;
class QToolBar;
class QToolButton;
class QWidget;

namespace isoscope {

/// Every command of the window with its name, icon, shortcut and tooltip; the window connects them to what
/// they do. Menus and tool bars are laid out here too. No two of them share a key, nor does one share a key
/// with editorKeys(): a key means the same wherever the focus is.
class Actions : public QObject {
    Q_OBJECT
  public:
    /// Shortcuts work while `window` is active.
    explicit Actions(QWidget* window);

    QAction *newFile, *newWindow, *open, *save, *saveAs, *keptTexts, *quit;
    QAction *copyIsosurface, *copyPicture, *exportInclude, *exportScene, *exportVirtualight, *exportImage;
    QAction *copyDifference, *pictureQueue, *exportMesh;
    QAction *followFile, *liveUpdate, *exportNote;
    QAction *exportAnimation, *exportFrames;
    QAction *undo, *redo, *cut, *copy, *paste, *selectAll;
    QAction *find, *replace, *findNext, *findPrevious, *comment, *adjustNumber, *fitContainer;
    QAction *insertFunction, *gallery, *startPage;
    QAction *fitView, *frontView, *topView, *sideView;
    QAction *resetView, *writeView, *redraw, *stop, *antialias;
    QAction *certified, *povray, *verdicts;
    QAction *overlayNone, *overlayHoles, *overlaySplit, *overlayDifference, *overlayGradient, *overlayCost;
    QAction *overlayCompare, *overlayPovray, *overlayPovrayDifference;
    QAction *inspectRay, *sectionPlane;
    QAction *showContainers, *showAxes, *showCuts;
    QAction *themeSystem, *themeLight, *themeDark, *themeHighContrast;
    QAction *wordWrap, *resetLayout, *includeFolders;
    QAction *largerText, *smallerText, *normalText;
    /// One of them is checked; their data is the size in percent, for setInterfaceSize().
    QList<QAction*> interfaceSizes;
    QList<QAction*> languages;
    QAction *nextPane, *previousPane;
    QAction *help, *lessons, *commands, *shortcuts, *whatsThis, *about;

    /// `recent` and `examples` are filled by others; `panels` are the docks' own actions.
    void fillMenuBar(QMenuBar* bar, QMenu* recent, QMenu* examples, const QList<QAction*>& panels) const;
    void fillToolBar(QToolBar* bar) const;
    /// The buttons that bear words, where there is room for them.
    QList<QToolButton*> fillViewTools(QToolBar* bar) const;
    void fillContextMenu(QWidget* picture) const;
    /// The words of a menu entry: without access key and dots, in any language.
    static QString plainText(const QString& text);
    /// What the pointer is told of a command: what it does, and its keys behind where it has some.
    static QString toolTip(const QString& text, const QKeySequence& keys);
    /// In the order of the menus. Their object names are theirs in every language.
    const QList<QAction*>& all() const { return all_; }

  private:
    QAction* add(const QString& text, const QString& toolTip, const char* icon = nullptr,
                 const QKeySequence& keys = {});
    void nameAll();
    void addFileActions();
    void addEditActions();
    void addViewActions();
    void addTextSizes();
    void addLanguages();
    void addStudyActions();
    QList<QAction*> overlays() const;

    QWidget* window_;
    QList<QAction*> all_;
    QMap<QAction*, QString> iconNames_;
};

}  // namespace isoscope
