// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/command_palette.h"
#include "widgets/interface_language.h"

#include <algorithm>
#include <QAction>
#include <QApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QScrollBar>
#include <QSettings>
#include <QTextDocumentFragment>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace isoscope {

namespace {

const QString recentKey = QStringLiteral("window/recentCommands");
const QString separator = QStringLiteral(" › ");
constexpr int recentKept = 12;
constexpr int rowsShown = 12, widest = 640, margin = 8;

/// Without the marks of rich text.
QString plainText(const QString& text) { return QTextDocumentFragment::fromHtml(text).toPlainText(); }

void collectFrom(QMenu* menu, const QString& prefix, QList<PaletteCommand>& commands) {
    for (QAction* action : menu->actions()) {
        if (action->isSeparator() || !action->isVisible() || action->text().isEmpty()) continue;
        const QString path = prefix + separator + withoutAccessKey(action->text());
        if (action->menu())
            collectFrom(action->menu(), path, commands);
        else
            commands.append({path, plainText(action->whatsThis()), action});
    }
}

bool beginsWord(const QString& path, const QString& part) {
    for (qsizetype at = path.indexOf(part); at >= 0; at = path.indexOf(part, at + 1))
        if (at == 0 || !path[at - 1].isLetterOrNumber()) return true;
    return false;
}

bool lettersInOrder(const QString& path, const QString& part) {
    qsizetype at = 0;
    for (const QChar letter : part) {
        at = path.indexOf(letter, at) + 1;
        if (at == 0) return false;
    }
    return true;
}

}  // namespace

std::optional<int> paletteRank(const QString& path, const QString& typed, const QString& help) {
    const QString name = path.toCaseFolded(), wanted = typed.simplified().toCaseFolded();
    if (wanted.isEmpty()) return 0;
    const QString own = name.section(separator, -1);
    if (own == wanted || own == wanted + QStringLiteral("…")) return 0;
    if (own.startsWith(wanted)) return 1;
    const QStringList parts = wanted.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    const auto each = [&](const auto& isFound) { return std::ranges::all_of(parts, isFound); };
    const auto beginsInName = [&](const QString& part) { return beginsWord(name, part); };
    if (each(beginsInName)) return 2;
    if (each([&](const QString& part) { return name.contains(part); })) return 3;
    const QString told = help.toCaseFolded();
    if (each([&](const QString& part) { return beginsInName(part) || beginsWord(told, part); })) return 4;
    if (each([&](const QString& part) { return lettersInOrder(name, part); })) return 5;
    return std::nullopt;
}

void CommandPalette::toggle(QMainWindow* window) {
    for (auto* open : window->findChildren<CommandPalette*>(QString(), Qt::FindDirectChildrenOnly))
        if (!open->isHidden()) return open->leave();
    auto* palette = new CommandPalette(window);
    palette->show();
    palette->raise();
    palette->field_->setFocus(Qt::PopupFocusReason);
}

CommandPalette::CommandPalette(QMainWindow* window)
    : QFrame(window),
      window_(window),
      focusBefore_(QApplication::focusWidget()),
      recent_(QSettings().value(recentKey).toStringList()) {
    setFrameShape(QFrame::StyledPanel);
    setFrameShadow(QFrame::Raised);
    setAutoFillBackground(true);
    setAccessibleName(tr("Commands"));
    setWhatsThis(
        tr("<p>Every command of the menus. Type words of its name, or of what it tells of itself, and press "
           "Enter.</p>"));
    field_ = new QLineEdit;
    field_->setPlaceholderText(tr("Type a command, then Enter"));
    field_->setAccessibleName(tr("Words of a command"));
    field_->setToolTip(tr("Lists the commands that these words name"));
    field_->installEventFilter(this);
    connect(field_, &QLineEdit::textChanged, this, &CommandPalette::fill);
    list_ = new QTreeWidget;
    list_->setColumnCount(2);
    list_->setHeaderHidden(true);
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setAllColumnsShowFocus(true);
    list_->setFocusPolicy(Qt::NoFocus);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setAccessibleName(tr("Commands with their keys"));
    list_->setToolTip(tr("The commands of the menus"));
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    connect(list_, &QTreeWidget::itemClicked, this, &CommandPalette::run);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(margin, margin, margin, margin);
    layout->addWidget(field_);
    layout->addWidget(list_);
    window->installEventFilter(this);
    collect();
    fill({});
    place();
}

void CommandPalette::collect() {
    for (const QAction* title : window_->menuBar()->actions())
        if (title->menu()) collectFrom(title->menu(), withoutAccessKey(title->text()), commands_);
}

void CommandPalette::fill(const QString& typed) {
    struct Match {
        int rank;
        qsizetype age;
        const PaletteCommand* command;
    };
    QList<Match> matches;
    for (const PaletteCommand& command : commands_) {
        const auto rank = paletteRank(command.path, typed, command.help);
        const qsizetype age = recent_.indexOf(command.path);
        if (rank) matches.append({*rank, age < 0 ? recent_.size() : age, &command});
    }
    std::stable_sort(matches.begin(), matches.end(), [](const Match& a, const Match& b) {
        return std::pair(a.rank, a.age) < std::pair(b.rank, b.age);
    });
    list_->clear();
    for (const Match& match : matches) {
        const QAction* action = match.command->action;
        const QString keys = action->shortcut().toString(QKeySequence::NativeText);
        const QString mark = action->isChecked() ? QStringLiteral("  ✓") : QString();
        auto* row = new QTreeWidgetItem(list_, {match.command->path + mark, keys});
        row->setData(0, Qt::UserRole, static_cast<qlonglong>(match.command - commands_.constData()));
        row->setToolTip(0, action->statusTip());
        row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        if (!action->isEnabled()) row->setFlags(Qt::ItemNeverHasChildren);
    }
    list_->setCurrentItem(nullptr);
    move(1);
    // Enter runs nothing that what was typed names less well than a command that cannot be run now.
    const int chosen = list_->currentIndex().row();
    if (chosen > 0 && matches[chosen].rank > matches.first().rank) list_->setCurrentItem(nullptr);
}

void CommandPalette::place() {
    const QRect room = window_->rect().adjusted(margin, 0, -margin, -margin);
    const int width = std::min(widest, room.width());
    const int top = window_->menuBar()->geometry().bottom() + 1;
    const int row = list_->sizeHintForRow(0) > 0 ? list_->sizeHintForRow(0) : fontMetrics().height() + 4;
    const int wanted = field_->sizeHint().height() + row * rowsShown + 4 * margin;
    setGeometry(room.center().x() - width / 2, top, width, std::min(wanted, room.bottom() - top));
}

void CommandPalette::move(int rows) {
    const QModelIndex current = list_->currentIndex();
    const int count = list_->topLevelItemCount(), step = rows < 0 ? -1 : 1;
    int row = current.isValid() ? current.row() : -1, wanted = row;
    // Over the rows that cannot be chosen.
    for (int left = std::abs(rows); left > 0 && row + step >= 0 && row + step < count;) {
        row += step;
        if (!(list_->topLevelItem(row)->flags() & Qt::ItemIsEnabled)) continue;
        wanted = row;
        --left;
    }
    if (wanted >= 0) list_->setCurrentItem(list_->topLevelItem(wanted));
}

void CommandPalette::run() {
    const QTreeWidgetItem* row = list_->currentItem();
    if (!row || !(row->flags() & Qt::ItemIsEnabled)) return;
    const PaletteCommand command = commands_[row->data(0, Qt::UserRole).toLongLong()];
    recent_.removeAll(command.path);
    recent_.prepend(command.path);
    QSettings().setValue(recentKey, QStringList(recent_.mid(0, recentKept)));
    const QPointer<QAction> action = command.action;
    leave();
    if (action) action->trigger();
}

void CommandPalette::leave() {
    if (isHidden()) return;
    const bool had = isAncestorOf(QApplication::focusWidget());
    hide();
    deleteLater();
    if (had && focusBefore_) focusBefore_->setFocus(Qt::PopupFocusReason);
}

QStringList CommandPalette::shown() const {
    QStringList paths;
    for (int i = 0; i < list_->topLevelItemCount(); ++i)
        paths << commands_[list_->topLevelItem(i)->data(0, Qt::UserRole).toLongLong()].path;
    return paths;
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    if (watched == window_ && event->type() == QEvent::Resize) place();
    if (watched != field_) return false;
    if (event->type() == QEvent::FocusOut) {
        // The field's own menu gives the focus back.
        if (static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason) leave();
        return false;
    }
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape)
        event->accept();
    if (event->type() != QEvent::KeyPress) return false;
    switch (static_cast<QKeyEvent*>(event)->key()) {
        case Qt::Key_Up: move(-1); return true;
        case Qt::Key_Down: move(1); return true;
        case Qt::Key_PageUp: move(-rowsShown); return true;
        case Qt::Key_PageDown: move(rowsShown); return true;
        case Qt::Key_Escape: leave(); return true;
        case Qt::Key_Return:
        case Qt::Key_Enter: run(); return true;
        // One field: Tab has nowhere to go.
        case Qt::Key_Tab:
        case Qt::Key_Backtab: return true;
        default: return false;
    }
}

}  // namespace isoscope
