// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/shortcut_window.h"

#include <algorithm>
#include <QAction>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QScrollBar>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <QVBoxLayout>

#include "app/desktop/window/command_keys.h"
#include "widgets/editor/editor_keys.h"
#include "widgets/interface_language.h"

namespace isoscope {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(ShortcutWindow)
};

QString keysOf(const QList<QKeySequence>& keys) {
    QStringList texts;
    for (const QKeySequence& sequence : keys) texts << sequence.toString(QKeySequence::NativeText);
    return texts.join(QStringLiteral(", "));
}

/// Entries of a submenu come under its name.
void addMenu(const QMenu* menu, const QString& prefix, const QList<QAction*>& editable,
             std::vector<ShortcutRow>& rows) {
    for (QAction* action : menu->actions()) {
        const bool mayChange = editable.contains(action);
        if (action->menu())
            addMenu(action->menu(), prefix + withoutAccessKey(action->text()) + QStringLiteral(": "),
                    editable, rows);
        else if (mayChange || !action->shortcuts().isEmpty())
            rows.push_back({prefix + withoutAccessKey(action->text()), keysOf(action->shortcuts()),
                            mayChange ? action : nullptr});
    }
}

std::vector<ShortcutRow> editorRows() {
    std::vector<ShortcutRow> rows;
    for (const EditorKey& entry : editorKeys()) {
        QList<QKeySequence> keys;
        for (const QKeyCombination key : entry.keys) keys << QKeySequence(key);
        QString text = keysOf(keys);
        if (entry.selecting != 0) text = Words::tr("%1; with Shift: selects").arg(text);
        rows.push_back({entry.name, text});
    }
    return rows;
}

}  // namespace

std::vector<ShortcutGroup> shortcutGroups(const QMenuBar* menus, const QList<QAction*>& editable) {
    std::vector<ShortcutGroup> groups;
    for (const QAction* title : menus->actions()) {
        if (!title->menu()) continue;
        ShortcutGroup group{withoutAccessKey(title->text()), {}};
        addMenu(title->menu(), {}, editable, group.rows);
        if (!group.rows.empty()) groups.push_back(std::move(group));
    }
    groups.push_back(
        {Words::tr("In the picture"),
         {{Words::tr("Turn"), Words::tr("Left drag, arrow keys")},
          {Words::tr("Shift"), Words::tr("Right or middle drag, Shift+drag, Shift+arrow keys")},
          {Words::tr("Come nearer, go away"), Words::tr("Wheel, + and -")},
          {Words::tr("Show everything"), Words::tr("F")},
          {Words::tr("Back to the camera of the text"), Words::tr("Double click, Home")},
          {Words::tr("Stop the picture"), Words::tr("Esc")},
          {Words::tr("Move the divider of a split view"), Words::tr("Drag it, Alt+Left, Alt+Right")},
          {Words::tr("Menu"), Words::tr("Right click, Menu")}}});
    groups.push_back({Words::tr("In the text"), editorRows()});
    groups.push_back(
        {Words::tr("With the mouse in the text"),
         {{Words::tr("Change the number under the mouse"), Words::tr("Ctrl+drag; Alt+drag and Alt+wheel")},
          {Words::tr("A tenth of a step, or ten"), Words::tr("Shift, or the other of Ctrl and Alt, as well")},
          {Words::tr("Take a drag back"), Words::tr("Esc, before the button is released")},
          {Words::tr("Size of the letters"), Words::tr("Ctrl+wheel")}}});
    groups.push_back(
        {Words::tr("In the panels"),
         {{Words::tr("Parameter: back to its first value"), Words::tr("Double click on the name")},
          {Words::tr("Parameter: another end of its range"), Words::tr("Double click on the end")},
          {Words::tr("Cross-section: shift, zoom, see all"), Words::tr("Drag, wheel, double click")},
          {Words::tr("Help: the page before, the next one"), Words::tr("Alt+Left, Alt+Right")},
          {Words::tr("Help: back to the text"), Words::tr("Esc")}}});
    return groups;
}

ShortcutWindow::ShortcutWindow(const QMenuBar* menus, const QList<QAction*>& editable, CommandKeys* keys,
                               QWidget* parent)
    : QDialog(parent), keys_(keys) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Keyboard and mouse"));
    build();
    fill(menus, editable);
    widen();
    connect(keys_, &CommandKeys::changed, this, &ShortcutWindow::showKeys);
    connect(table_, &QTreeWidget::currentItemChanged, this, &ShortcutWindow::showCurrent);
    connect(table_, &QTreeWidget::itemActivated, this, [this] {
        if (action()) field_->setFocus(Qt::OtherFocusReason);
    });
    showCurrent();
    search_->setFocus();
}

void ShortcutWindow::build() {
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
    table_->setToolTip(tr("Enter or a double click goes to the field for the command's keys"));
    table_->setRootIsDecorated(false);
    table_->setItemsExpandable(false);
    table_->setAlternatingRowColors(true);
    table_->setUniformRowHeights(true);
    table_->setAllColumnsShowFocus(true);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    resetAll_ = buttons->addButton(tr("Reset All"), QDialogButtonBox::ResetRole);
    resetAll_->setToolTip(tr("Give every command the keys that the program comes with"));
    for (QAbstractButton* button : buttons->buttons())
        if (auto* push = qobject_cast<QPushButton*>(button)) push->setAutoDefault(false);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(resetAll_, &QPushButton::clicked, keys_, &CommandKeys::resetAll);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(search_);
    layout->addWidget(table_);
    layout->addWidget(buildEditor());
    layout->addWidget(buttons);
}

QWidget* ShortcutWindow::buildEditor() {
    auto* editor = new QWidget;
    auto* layout = new QGridLayout(editor);
    layout->setContentsMargins(0, 0, 0, 0);
    name_ = new QLabel;
    name_->setTextFormat(Qt::PlainText);
    field_ = new QKeySequenceEdit;
    field_->setAccessibleName(tr("New keys"));
    field_->setToolTip(tr("Press the keys that shall call the command"));
    const auto button = [this](const QString& text, const QString& toolTip, auto act) {
        auto* made = new QPushButton(text);
        made->setToolTip(toolTip);
        made->setAutoDefault(false);
        connect(made, &QPushButton::clicked, this, act);
        return made;
    };
    set_ = button(tr("Set"), tr("Give the command these keys"), [this] { assign(); });
    remove_ =
        button(tr("No Keys"), tr("Take the command's keys away"), [this] { keys_->assign(action(), {}); });
    reset_ = button(tr("Reset"), tr("Give the command the keys that it came with"),
                    [this] { keys_->reset(action()); });
    verdict_ = new QLabel;
    verdict_->setWordWrap(true);
    verdict_->setAccessibleDescription(tr("What these keys would do"));
    verdict_->setMinimumHeight(2 * verdict_->fontMetrics().height());
    verdict_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    layout->addWidget(name_, 0, 0, 1, 4);
    layout->addWidget(field_, 1, 0);
    layout->addWidget(set_, 1, 1);
    layout->addWidget(remove_, 1, 2);
    layout->addWidget(reset_, 1, 3);
    layout->addWidget(verdict_, 2, 0, 1, 4);
    layout->setColumnStretch(0, 1);
    connect(field_, &QKeySequenceEdit::keySequenceChanged, this, &ShortcutWindow::judge);
    return editor;
}

void ShortcutWindow::fill(const QMenuBar* menus, const QList<QAction*>& editable) {
    for (const ShortcutGroup& group : shortcutGroups(menus, editable)) {
        auto* title = new QTreeWidgetItem(table_, {group.title});
        title->setFirstColumnSpanned(true);
        title->setFlags(Qt::ItemIsEnabled);
        QFont bold = table_->font();
        bold.setBold(true);
        title->setFont(0, bold);
        for (const ShortcutRow& row : group.rows) {
            auto* item = new QTreeWidgetItem(title, {row.name, row.keys});
            if (!row.action) continue;
            item->setData(0, Qt::UserRole, actions_.size());
            actions_ << row.action;
        }
    }
    table_->expandAll();
}

void ShortcutWindow::widen() {
    // As wide as its longest lines.
    constexpr int gap = 24, height = 680;
    int width = 0;
    for (const int column : {0, 1}) {
        table_->resizeColumnToContents(column);
        table_->setColumnWidth(column, table_->columnWidth(column) + gap);
        width += table_->columnWidth(column);
    }
    table_->setMinimumWidth(width + table_->verticalScrollBar()->sizeHint().width() +
                            2 * table_->frameWidth());
    resize(sizeHint().width(), height);
}

void ShortcutWindow::showKeys() {
    for (QTreeWidgetItemIterator at(table_); *at; ++at)
        if (const QVariant number = (*at)->data(0, Qt::UserRole); number.isValid())
            (*at)->setText(1, keysOf(actions_[number.toInt()]->shortcuts()));
    showCurrent();
}

QAction* ShortcutWindow::action() const {
    const QTreeWidgetItem* item = table_->currentItem();
    const QVariant number = item ? item->data(0, Qt::UserRole) : QVariant();
    return number.isValid() ? actions_[number.toInt()] : nullptr;
}

void ShortcutWindow::edit(QAction* wanted) {
    for (QTreeWidgetItemIterator at(table_); *at; ++at)
        if (const QVariant number = (*at)->data(0, Qt::UserRole);
            number.isValid() && actions_[number.toInt()] == wanted)
            table_->setCurrentItem(*at);
    if (action() == wanted) field_->setFocus(Qt::OtherFocusReason);
}

void ShortcutWindow::showCurrent() {
    const QAction* current = action();
    name_->setText(current ? tr("Keys of “%1”:").arg(table_->currentItem()->text(0))
                           : tr("Choose a command to change its keys."));
    field_->setEnabled(current);
    field_->setKeySequence(current ? current->shortcut() : QKeySequence());
    remove_->setEnabled(current && !current->shortcuts().isEmpty());
    reset_->setEnabled(current && !keys_->isUsual(current));
    resetAll_->setEnabled(
        std::ranges::any_of(actions_, [this](const QAction* one) { return !keys_->isUsual(one); }));
    judge();
}

void ShortcutWindow::judge() {
    QKeySequence wanted = field_->keySequence();
    if (wanted.count() > 1) {
        // The field collects several; the last one counts.
        field_->setKeySequence(QKeySequence(wanted[static_cast<uint>(wanted.count()) - 1]));
        return;
    }
    const QAction* current = action();
    const QString refusal = CommandKeys::refusal(wanted);
    const QAction* owner = keys_->owner(wanted);
    set_->setEnabled(current && !wanted.isEmpty() && refusal.isEmpty() && owner != current);
    if (!current || wanted.isEmpty() || owner == current)
        verdict_->clear();
    else if (!refusal.isEmpty())
        verdict_->setText(refusal);
    else if (owner)
        verdict_->setText(
            tr("“%1” has these keys now and would lose them.").arg(withoutAccessKey(owner->text())));
    else
        verdict_->setText(tr("These keys are free."));
}

void ShortcutWindow::assign() {
    if (action() && keys_->assign(action(), field_->keySequence())) table_->setFocus(Qt::OtherFocusReason);
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
