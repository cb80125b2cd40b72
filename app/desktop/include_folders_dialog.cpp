// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/include_folders_dialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

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
        tr("#include looks beside the scene first, then in these folders, from the top. The standard "
           "include files are built in and need no folder."));
    text->setWordWrap(true);
    layout->addWidget(text);
    list_ = new QListWidget;
    list_->setAccessibleName(tr("Include folders"));
    list_->setToolTip(tr("Folders in the order in which they are searched; drag to change it"));
    list_->setDragDropMode(QAbstractItemView::InternalMove);
    list_->addItems(QSettings().value(settingsKey).toStringList());
    layout->addWidget(list_);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    QPushButton* add = buttons->addButton(tr("Add…"), QDialogButtonBox::ActionRole);
    add->setIcon(themeIcon(QStringLiteral("list-add")));
    add->setToolTip(tr("Add a folder"));
    QPushButton* remove = buttons->addButton(tr("Remove"), QDialogButtonBox::ActionRole);
    remove->setIcon(themeIcon(QStringLiteral("list-remove")));
    remove->setToolTip(tr("Remove the selected folder from the list"));
    connect(add, &QPushButton::clicked, this, &IncludeFoldersDialog::addFolder);
    connect(remove, &QPushButton::clicked, this, &IncludeFoldersDialog::removeFolder);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    resize(520, 320);
}

std::vector<std::filesystem::path> IncludeFoldersDialog::storedPaths() {
    std::vector<std::filesystem::path> paths;
    for (const QString& path : QSettings().value(settingsKey).toStringList())
        paths.emplace_back(path.toStdString());
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
