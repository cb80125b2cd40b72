// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/shortcut_window.h"

#include <algorithm>
#include <QAction>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QScrollBar>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "widgets/editor/editor_keys.h"

namespace isoscope {

namespace {

QString plain(QString title) {
    title.remove(QLatin1Char('&'));
    return title;
}

QString keysOf(const QList<QKeySequence>& keys) {
    QStringList texts;
    for (const QKeySequence& sequence : keys) texts << sequence.toString(QKeySequence::NativeText);
    return texts.join(QStringLiteral(", "));
}

/// Entries of a submenu come under its name.
void addMenu(const QMenu* menu, const QString& prefix, std::vector<ShortcutRow>& rows) {
    for (const QAction* action : menu->actions()) {
        if (action->menu())
            addMenu(action->menu(), prefix + plain(action->text()) + QStringLiteral(": "), rows);
        else if (!action->shortcuts().isEmpty())
            rows.push_back({prefix + plain(action->text()), keysOf(action->shortcuts())});
    }
}

std::vector<ShortcutRow> editorRows() {
    std::vector<ShortcutRow> rows;
    for (const EditorKey& entry : editorKeys()) {
        QList<QKeySequence> keys;
        for (const QKeyCombination key : entry.keys) keys << QKeySequence(key);
        QString text = keysOf(keys);
        if (entry.selecting != 0)
            text = QCoreApplication::translate("ShortcutWindow", "%1; with Shift: selects").arg(text);
        rows.push_back({entry.name, text});
    }
    return rows;
}

}  // namespace

std::vector<ShortcutGroup> shortcutGroups(const QMenuBar* menus) {
    const auto tr = [](const char* text) { return QCoreApplication::translate("ShortcutWindow", text); };
    std::vector<ShortcutGroup> groups;
    for (const QAction* title : menus->actions()) {
        if (!title->menu()) continue;
        ShortcutGroup group{plain(title->text()), {}};
        addMenu(title->menu(), {}, group.rows);
        if (!group.rows.empty()) groups.push_back(std::move(group));
    }
    groups.push_back({tr("In the picture"),
                      {{tr("Turn"), tr("Left drag, arrow keys")},
                       {tr("Shift"), tr("Right or middle drag, Shift+drag, Shift+arrow keys")},
                       {tr("Come nearer, go away"), tr("Wheel, + and -")},
                       {tr("Show everything"), tr("F")},
                       {tr("Back to the camera of the text"), tr("Double click, Home")},
                       {tr("Stop the picture"), tr("Esc")},
                       {tr("Move the divider of a split view"), tr("Drag it, Alt+Left, Alt+Right")},
                       {tr("Menu"), tr("Right click, Menu")}}});
    groups.push_back({tr("In the text"), editorRows()});
    groups.push_back({tr("With the mouse in the text"),
                      {{tr("Change the number under the mouse"), tr("Ctrl+drag; Alt+drag and Alt+wheel")},
                       {tr("A tenth of a step, or ten"), tr("Shift, or the other of Ctrl and Alt, as well")},
                       {tr("Take a drag back"), tr("Esc, before the button is released")},
                       {tr("Size of the letters"), tr("Ctrl+wheel")}}});
    groups.push_back({tr("In the panels"),
                      {{tr("Parameter: back to its first value"), tr("Double click on the name")},
                       {tr("Parameter: another end of its range"), tr("Double click on the end")},
                       {tr("Cross-section: shift, zoom, see all"), tr("Drag, wheel, double click")},
                       {tr("Help: the page before, the next one"), tr("Alt+Left, Alt+Right")},
                       {tr("Help: back to the text"), tr("Esc")}}});
    return groups;
}

ShortcutWindow::ShortcutWindow(const QMenuBar* menus, QWidget* parent) : QDialog(parent) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Keyboard and mouse"));
    search_ = new QLineEdit;
    search_->setPlaceholderText(tr("Search commands and keys"));
    search_->setClearButtonEnabled(true);
    search_->setAccessibleName(tr("Search commands and keys"));
    search_->setToolTip(tr("Shows only lines that contain these words"));
    connect(search_, &QLineEdit::textChanged, this, &ShortcutWindow::filter);

    table_ = new QTreeWidget;
    table_->setColumnCount(2);
    table_->setHeaderLabels({tr("Command"), tr("Keys or mouse")});
    table_->setAccessibleName(tr("Commands with their keys"));
    table_->setToolTip(tr("All commands that have keys"));
    table_->setRootIsDecorated(false);
    table_->setItemsExpandable(false);
    table_->setAlternatingRowColors(true);
    table_->setUniformRowHeights(true);
    fill(menus);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(search_);
    layout->addWidget(table_);
    layout->addWidget(buttons);
    // As wide as its longest lines.
    constexpr int gap = 24, height = 640;
    int width = 0;
    for (const int column : {0, 1}) {
        table_->resizeColumnToContents(column);
        table_->setColumnWidth(column, table_->columnWidth(column) + gap);
        width += table_->columnWidth(column);
    }
    table_->setMinimumWidth(width + table_->verticalScrollBar()->sizeHint().width() +
                            2 * table_->frameWidth());
    resize(sizeHint().width(), height);
    search_->setFocus();
}

void ShortcutWindow::fill(const QMenuBar* menus) {
    for (const ShortcutGroup& group : shortcutGroups(menus)) {
        auto* title = new QTreeWidgetItem(table_, {group.title});
        title->setFirstColumnSpanned(true);
        title->setFlags(Qt::ItemIsEnabled);
        QFont bold = table_->font();
        bold.setBold(true);
        title->setFont(0, bold);
        for (const ShortcutRow& row : group.rows) new QTreeWidgetItem(title, {row.name, row.keys});
    }
    table_->expandAll();
}

void ShortcutWindow::filter(const QString& words) {
    const QStringList parts = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    for (int i = 0; i < table_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* group = table_->topLevelItem(i);
        bool any = false;
        for (int j = 0; j < group->childCount(); ++j) {
            QTreeWidgetItem* row = group->child(j);
            const QString line =
                group->text(0) + QLatin1Char(' ') + row->text(0) + QLatin1Char(' ') + row->text(1);
            const bool shown = std::all_of(parts.begin(), parts.end(), [&](const QString& part) {
                return line.contains(part, Qt::CaseInsensitive);
            });
            row->setHidden(!shown);
            any = any || shown;
        }
        group->setHidden(!any);
    }
}

}  // namespace isoscope
