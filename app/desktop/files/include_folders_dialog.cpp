// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/files/include_folders_dialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

#include "core/language/directives/library_paths.h"
#include "widgets/icons.h"

namespace isoscope {

namespace {

const QString settingsKey = QStringLiteral("includeFolders");

}  // namespace

IncludeFoldersDialog::IncludeFoldersDialog(QWidget* parent) : QDialog(parent) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Include folders"));
    auto* layout = new QVBoxLayout(this);
    auto* text = new QLabel(
        tr("#include looks beside the scene first, then in these folders, from the top, then in those of an "
           "installed POV-Ray."));
    text->setWordWrap(true);
    layout->addWidget(text);
    list_ = new QListWidget;
    list_->setAccessibleName(tr("Include folders"));
    list_->setToolTip(tr("Folders in the order in which they are searched; drag to change it"));
    list_->setDragDropMode(QAbstractItemView::InternalMove);
    list_->addItems(QSettings().value(settingsKey).toStringList());
    auto* add = new QPushButton(themeIcon(QStringLiteral("list-add")), tr("Add…"));
    add->setToolTip(tr("Add a folder"));
    auto* remove = new QPushButton(themeIcon(QStringLiteral("list-remove")), tr("Remove"));
    remove->setToolTip(tr("Remove the selected folder from the list"));
    remove->setEnabled(false);
    connect(list_, &QListWidget::currentRowChanged, remove,
            [remove](int row) { remove->setEnabled(row >= 0); });
    auto* besides = new QVBoxLayout;
    besides->addWidget(add);
    besides->addWidget(remove);
    besides->addStretch(1);
    auto* folders = new QHBoxLayout;
    folders->addWidget(list_, 1);
    folders->addLayout(besides);
    layout->addLayout(folders);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setToolTip(tr("Use these folders"));
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Leave the folders as they were"));
    connect(add, &QPushButton::clicked, this, &IncludeFoldersDialog::addFolder);
    connect(remove, &QPushButton::clicked, this, &IncludeFoldersDialog::removeFolder);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    resize(520, 320);
}

std::vector<std::filesystem::path> IncludeFoldersDialog::searchedPaths() {
    std::vector<std::filesystem::path> paths;
    for (const QString& path : QSettings().value(settingsKey).toStringList())
        paths.emplace_back(path.toStdString());
    const auto installed = installedLibraryPaths();
    paths.insert(paths.end(), installed.begin(), installed.end());
    return paths;
}

void IncludeFoldersDialog::accept() {
    QStringList paths;
    for (int i = 0; i < list_->count(); ++i) paths << list_->item(i)->text();
    QSettings().setValue(settingsKey, paths);
    QDialog::accept();
}

void IncludeFoldersDialog::addFolder() {
    const QString path = QFileDialog::getExistingDirectory(this, tr("Add an include folder"));
    if (!path.isEmpty() && list_->findItems(path, Qt::MatchExactly).isEmpty()) list_->addItem(path);
}

void IncludeFoldersDialog::removeFolder() { delete list_->currentItem(); }

}  // namespace isoscope
