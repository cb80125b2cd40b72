// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/find_bar.h"

#include <algorithm>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/editor/scene_editor.h"
#include "widgets/icons.h"

namespace isoscope {
namespace {

using Sci = QsciScintillaBase;

constexpr int indicator = 17;
constexpr int searchPause = 150;  // after a change of the text, milliseconds
constexpr std::size_t markLimit = 2000;

QToolButton* makeOption(const QString& text, const QString& toolTip, const QString& name, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setText(text);
    button->setToolTip(toolTip);
    button->setAccessibleName(name);
    button->setCheckable(true);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

QToolButton* makeAction(const QString& icon, const QString& toolTip, const QString& name, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setIcon(themeIcon(icon));
    button->setToolTip(toolTip);
    button->setAccessibleName(name);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

QLineEdit* makeField(const QString& name, const QString& toolTip, QWidget* parent) {
    auto* field = new QLineEdit(parent);
    field->setPlaceholderText(name);
    field->setAccessibleName(name);
    field->setToolTip(toolTip);
    field->setClearButtonEnabled(true);
    return field;
}

}  // namespace

FindBar::FindBar(SceneEditor* editor, QWidget* parent) : QWidget(parent), editor_(editor) {
    build();
    hide();
    searchLater_.setSingleShot(true);
    searchLater_.setInterval(searchPause);
    connect(&searchLater_, &QTimer::timeout, this, &FindBar::search);
    for (auto signal : {&SceneEditor::textEdited, &SceneEditor::numberReplaced, &SceneEditor::textLoaded})
        connect(editor_, signal, this, [this] {
            if (isVisible()) searchLater_.start();
        });
    editor_->installEventFilter(this);
    editor_->indicatorDefine(QsciScintilla::FullBoxIndicator, indicator);
    editor_->setIndicatorDrawUnder(true, indicator);
}

FindBar::~FindBar() = default;

void FindBar::build() {
    setAccessibleName(tr("Find and replace"));
    buildFindRow();
    buildReplaceRow();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 3, 4, 3);
    layout->setSpacing(3);
    layout->addWidget(findRow_);
    layout->addWidget(replaceRow_);
}

void FindBar::buildFindRow() {
    findRow_ = new QWidget(this);
    pattern_ = makeField(tr("Find"), tr("What to look for. Enter: next, Shift+Enter: previous"), findRow_);
    caseSensitive_ = makeOption("Aa", tr("Upper and lower case differ"), tr("Match case"), findRow_);
    wholeWord_ = makeOption("|ab|", tr("Whole words only"), tr("Whole words"), findRow_);
    regular_ = makeOption(".*", tr("Regular expression; \\1 in the replacement is the first group"),
                          tr("Regular expression"), findRow_);
    count_ = new QLabel(findRow_);
    count_->setAccessibleDescription(tr("Number of matches"));
    count_->setMinimumWidth(fontMetrics().horizontalAdvance(tr("%1 of %2").arg(100).arg(1000)));
    previous_ = makeAction("go-up", tr("Previous match (Shift+F3)"), tr("Previous match"), findRow_);
    next_ = makeAction("go-down", tr("Next match (F3)"), tr("Next match"), findRow_);
    QToolButton* close = makeAction("window-close", tr("Close (Escape)"), tr("Close"), findRow_);
    auto* layout = new QHBoxLayout(findRow_);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(3);
    layout->addWidget(pattern_, 1);
    for (QWidget* widget : std::initializer_list<QWidget*>{caseSensitive_, wholeWord_, regular_, count_,
                                                           previous_, next_, close})
        layout->addWidget(widget);
    connect(pattern_, &QLineEdit::textChanged, this, &FindBar::textTyped);
    for (QToolButton* option : {caseSensitive_, wholeWord_, regular_})
        connect(option, &QToolButton::toggled, this, &FindBar::textTyped);
    connect(previous_, &QToolButton::clicked, this, &FindBar::findPrevious);
    connect(next_, &QToolButton::clicked, this, &FindBar::findNext);
    connect(close, &QToolButton::clicked, this, &FindBar::hideBar);
}

void FindBar::buildReplaceRow() {
    replaceRow_ = new QWidget(this);
    replacement_ =
        makeField(tr("Replace with"), tr("What to put in its place. Enter replaces the match"), replaceRow_);
    replaceOne_ = new QPushButton(tr("Replace"), replaceRow_);
    replaceOne_->setToolTip(tr("Replaces the selected match and goes to the next"));
    replaceOne_->setAccessibleName(tr("Replace"));
    replaceAll_ = new QPushButton(tr("Replace all"), replaceRow_);
    replaceAll_->setToolTip(tr("Replaces every match; one undo brings them back"));
    replaceAll_->setAccessibleName(tr("Replace all"));
    auto* layout = new QHBoxLayout(replaceRow_);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(3);
    layout->addWidget(replacement_, 1);
    layout->addWidget(replaceOne_);
    layout->addWidget(replaceAll_);
    connect(replaceOne_, &QPushButton::clicked, this, &FindBar::replaceOne);
    connect(replaceAll_, &QPushButton::clicked, this, &FindBar::replaceAll);
}

void FindBar::showFind() { open(false); }
void FindBar::showReplace() { open(true); }

void FindBar::open(bool withReplace) {
    replaceRow_->setVisible(withReplace);
    const QString selected = editor_->selectedText();
    typedFrom_ = editor_->SendScintilla(Sci::SCI_GETSELECTIONSTART);
    show();
    if (!selected.isEmpty() && !selected.contains('\n') && selected != pattern_->text())
        pattern_->setText(selected);
    else
        textTyped();
    pattern_->setFocus(Qt::ShortcutFocusReason);
    pattern_->selectAll();
}

void FindBar::hideBar() {
    if (!isVisible()) return;
    hide();
    searchLater_.stop();
    result_ = {};
    markAll();
    editor_->setFocus(Qt::OtherFocusReason);
}

void FindBar::textTyped() {
    search();
    const auto from = std::find_if(result_.matches.begin(), result_.matches.end(),
                                   [this](const SearchMatch& match) { return match.begin >= typedFrom_; });
    if (result_.matches.empty()) return;
    select(from == result_.matches.end() ? 0 : static_cast<int>(from - result_.matches.begin()));
}

void FindBar::search() {
    searchLater_.stop();
    SearchRequest request;
    request.pattern = pattern_->text();
    request.replacement = replacement_->text();
    request.caseSensitive = caseSensitive_->isChecked();
    request.wholeWord = wholeWord_->isChecked();
    request.regular = regular_->isChecked();
    result_ = searchText(editor_->utf8(), request);
    const long begin = editor_->SendScintilla(Sci::SCI_GETSELECTIONSTART);
    const long end = editor_->SendScintilla(Sci::SCI_GETSELECTIONEND);
    current_ = -1;
    for (std::size_t i = 0; i < result_.matches.size(); ++i)
        if (result_.matches[i].begin == begin && result_.matches[i].end == end)
            current_ = static_cast<int>(i);
    markAll();
    showCount();
}

void FindBar::showCount() {
    const bool any = !result_.matches.empty();
    const QString total = QString::number(result_.matches.size()) + (result_.cutOff ? "+" : "");
    if (pattern_->text().isEmpty())
        count_->setText({});
    else if (!result_.error.isEmpty())
        count_->setText(tr("Invalid"));
    else if (!any)
        count_->setText(tr("None"));
    else if (current_ < 0)
        count_->setText(tr("%1 found").arg(total));
    else
        count_->setText(tr("%1 of %2").arg(current_ + 1).arg(total));
    count_->setToolTip(result_.error.isEmpty()
                           ? tr("Matches in the text")
                           : tr("The regular expression is not valid: %1").arg(result_.error));
    for (QWidget* widget : std::initializer_list<QWidget*>{previous_, next_, replaceOne_, replaceAll_})
        widget->setEnabled(any);
}

void FindBar::markAll() {
    editor_->setIndicatorForegroundColor(
        editor_->look() == Look::light ? QColor(0xff, 0xd0, 0x30, 120) : QColor(0xd0, 0xa0, 0x20, 90),
        indicator);
    editor_->SendScintilla(Sci::SCI_SETINDICATORCURRENT, indicator);
    editor_->SendScintilla(Sci::SCI_INDICATORCLEARRANGE, 0UL, editor_->SendScintilla(Sci::SCI_GETLENGTH));
    editor_->SendScintilla(Sci::SCI_SETINDICATORVALUE, 1);
    for (std::size_t i = 0; i < result_.matches.size() && i < markLimit; ++i) {
        const SearchMatch& match = result_.matches[i];
        editor_->SendScintilla(Sci::SCI_INDICATORFILLRANGE, static_cast<unsigned long>(match.begin),
                               match.end - match.begin);
    }
}

void FindBar::select(int index) {
    current_ = index;
    const SearchMatch& match = result_.matches[static_cast<std::size_t>(index)];
    QWidget* focus = window()->focusWidget();
    editor_->jumpTo({0, static_cast<std::uint32_t>(match.begin), static_cast<std::uint32_t>(match.end)});
    // Typing goes on where it was.
    if (focus && isAncestorOf(focus)) focus->setFocus(Qt::OtherFocusReason);
    showCount();
}

void FindBar::findNext() { step(true); }
void FindBar::findPrevious() { step(false); }

void FindBar::step(bool forward) {
    if (!isVisible() && pattern_->text().isEmpty()) return showFind();
    search();
    const auto& matches = result_.matches;
    if (matches.empty()) return;
    const int count = static_cast<int>(matches.size());
    const long begin = editor_->SendScintilla(Sci::SCI_GETSELECTIONSTART);
    const long end = editor_->SendScintilla(Sci::SCI_GETSELECTIONEND);
    int index = current_;
    if (index >= 0) {
        index = (index + (forward ? 1 : count - 1)) % count;
    } else if (forward) {
        const auto next =
            std::find_if(matches.begin(), matches.end(), [&](const auto& m) { return m.begin >= end; });
        index = next == matches.end() ? 0 : static_cast<int>(next - matches.begin());
    } else {
        const auto next =
            std::find_if(matches.rbegin(), matches.rend(), [&](const auto& m) { return m.end <= begin; });
        index = next == matches.rend() ? count - 1 : static_cast<int>(matches.rend() - next) - 1;
    }
    if (isVisible()) return select(index);
    // F3 with the bar closed: no marks are left behind.
    const SearchMatch match = matches[static_cast<std::size_t>(index)];
    result_ = {};
    markAll();
    editor_->jumpTo({0, static_cast<std::uint32_t>(match.begin), static_cast<std::uint32_t>(match.end)});
}

void FindBar::replaceOne() {
    search();
    if (result_.matches.empty()) return;
    if (current_ < 0) return step(true);
    const SearchMatch match = result_.matches[static_cast<std::size_t>(current_)];
    editor_->replaceText({match});
    const int behind = match.begin + static_cast<int>(match.replacement.toUtf8().size());
    editor_->SendScintilla(Sci::SCI_SETEMPTYSELECTION, static_cast<unsigned long>(behind));
    search();
    if (!result_.matches.empty()) step(true);
}

void FindBar::replaceAll() {
    search();
    const auto count = result_.matches.size();
    if (count == 0) return;
    editor_->replaceText(result_.matches);
    search();
    count_->setText(tr("%1 replaced").arg(count));
}

void FindBar::keyPressEvent(QKeyEvent* event) {
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (event->key() == Qt::Key_Escape) return hideBar();
    if (event->matches(QKeySequence::FindPrevious)) return findPrevious();
    if (event->matches(QKeySequence::FindNext)) return findNext();
    if (event->matches(QKeySequence::Find)) return showFind();
    if (event->keyCombination() == (Qt::CTRL | Qt::Key_H)) return showReplace();
    if (enter && replacement_->hasFocus()) return replaceOne();
    if (enter && pattern_->hasFocus()) return step(!(event->modifiers() & Qt::ShiftModifier));
    QWidget::keyPressEvent(event);
}

bool FindBar::eventFilter(QObject* watched, QEvent* event) {
    if (watched == editor_ && event->type() == QEvent::KeyPress) {
        // Where the window's menu has these keys they do not come here.
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Find)) return showFind(), true;
        if (key->keyCombination() == (Qt::CTRL | Qt::Key_H)) return showReplace(), true;
        if (key->matches(QKeySequence::FindNext)) return findNext(), true;
        if (key->matches(QKeySequence::FindPrevious)) return findPrevious(), true;
        if (key->key() == Qt::Key_Escape && isVisible() && !editor_->isListActive() &&
            !editor_->isCallTipActive())
            return hideBar(), true;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace isoscope
