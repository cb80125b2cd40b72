// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/icons.h"

#include <QApplication>
#include <QHash>
#include <QStandardPaths>
#include <QStyle>

namespace isoscope {
namespace {

/// Of icons that the style has nothing like.
constexpr auto noPixmap = QStyle::SP_CustomBase;

QStyle::StandardPixmap standardPixmap(const QString& name) {
    static const QHash<QString, QStyle::StandardPixmap> pixmaps = {
        {"document-new", QStyle::SP_FileIcon},
        {"document-open", QStyle::SP_DialogOpenButton},
        {"document-save", QStyle::SP_DialogSaveButton},
        {"document-save-as", QStyle::SP_DialogSaveButton},
        {"edit-undo", QStyle::SP_ArrowBack},
        {"edit-redo", QStyle::SP_ArrowForward},
        {"edit-find", QStyle::SP_FileDialogContentsView},
        {"edit-find-replace", QStyle::SP_FileDialogDetailedView},
        {"edit-clear", QStyle::SP_DialogResetButton},
        {"process-stop", QStyle::SP_BrowserStop},
        {"help-about", QStyle::SP_MessageBoxInformation},
        {"go-up-search", QStyle::SP_ArrowUp},
        {"go-down-search", QStyle::SP_ArrowDown},
        {"document-export", QStyle::SP_DialogSaveButton},
        {"application-exit", QStyle::SP_DialogCloseButton},
        {"go-up", QStyle::SP_ArrowUp},
        {"go-down", QStyle::SP_ArrowDown},
        {"dialog-error", QStyle::SP_MessageBoxCritical},
        {"dialog-warning", QStyle::SP_MessageBoxWarning},
        {"dialog-information", QStyle::SP_MessageBoxInformation},
        {"window-close", QStyle::SP_TitleBarCloseButton},
        {"view-refresh", QStyle::SP_BrowserReload},
        {"media-playback-start", QStyle::SP_MediaPlay},
        {"media-playback-stop", QStyle::SP_MediaStop},
        {"help-contents", QStyle::SP_DialogHelpButton},
        {"go-home", QStyle::SP_DirHomeIcon},
    };
    return pixmaps.value(name, noPixmap);
}

}  // namespace

void useIconTheme(bool dark) {
    // The platform plug-in "offscreen" does not know the system's folders.
    QStringList paths = QIcon::themeSearchPaths();
    const QStringList folders = QStandardPaths::locateAll(QStandardPaths::GenericDataLocation, "icons",
                                                          QStandardPaths::LocateDirectory);
    for (const QString& folder : folders + QStringList{"/usr/share/icons", ":/icons"})
        if (!paths.contains(folder)) paths << folder;
    QIcon::setThemeSearchPaths(paths);
    QIcon::setFallbackThemeName("hicolor");
    QIcon::setThemeName(dark ? "breeze-dark" : "breeze");
}

QIcon themeIcon(const QString& name) {
    const QIcon icon = QIcon::fromTheme(name);
    // A theme that lacks the icon, or one whose pictures cannot be read without Qt's SVG plug-in.
    if (!icon.isNull() && !icon.pixmap(16, 16).isNull()) return icon;
    const QStyle::StandardPixmap pixmap = standardPixmap(name);
    return pixmap == noPixmap ? QIcon() : QApplication::style()->standardIcon(pixmap);
}

}  // namespace isoscope
