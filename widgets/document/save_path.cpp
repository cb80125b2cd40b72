// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/document/save_path.h"

#include <QDir>
#include <QFileDialog>
#include <QStandardPaths>

namespace isoscope {

QString chooseSavePath(QWidget* parent, const QString& title, const QString& suggested, const QString& filter,
                       const QString& suffix) {
    QFileDialog dialog(parent, title, {}, filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setFileMode(QFileDialog::AnyFile);
    dialog.setDefaultSuffix(suffix);
    dialog.setDirectory(QFileInfo(suggested).absolutePath());
    dialog.selectFile(suggested);
    if (dialog.exec() != QDialog::Accepted) return {};
    return dialog.selectedFiles().value(0);
}

QString pathInDocuments(const QString& name) {
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QDir(QFileInfo(documents).isDir() ? documents : QDir::homePath()).filePath(name);
}

}  // namespace isoscope
