// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/help_panel.h"

#include <algorithm>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QStackedWidget>
#include <QStandardItemModel>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include "widgets/help/help_browser.h"
#include "widgets/icons.h"
#include "widgets/word_filter.h"

namespace isoscope {
namespace {

enum Role { addressRole = Qt::UserRole + 1, searchRole, orderRole };

}  // namespace

HelpPanel::HelpPanel(QWidget* parent)
    : QWidget(parent), pages_(new QStandardItemModel(this)), filter_(new WordFilter(this)) {
    setAccessibleName(tr("Help"));
    browser_ = new HelpBrowser(&library_, this);
    QWidget* bar = makeBar();
    stack_ = new QStackedWidget;
    stack_->addWidget(browser_);
    stack_->addWidget(makeList());
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addWidget(bar);
    layout->addWidget(stack_, 1);
    layout->addWidget(makeFindRow());
    fillList();
    connect(browser_, &HelpBrowser::pageChanged, this, &HelpPanel::pageChanged);
    connect(browser_, &HelpBrowser::sceneRequested, this, &HelpPanel::sceneRequested);
    for (QWidget* one : {static_cast<QWidget*>(browser_), static_cast<QWidget*>(search_),
                         static_cast<QWidget*>(list_), static_cast<QWidget*>(find_)})
        one->installEventFilter(this);
    pageChanged();
}

HelpPanel::~HelpPanel() = default;

QSize HelpPanel::sizeHint() const {
    // About 60 letters to a line.
    constexpr int letters = 60, lines = 40;
    return {letters * fontMetrics().averageCharWidth(), lines * fontMetrics().height()};
}

QToolButton* HelpPanel::addButton(QWidget* row, const char* icon, const QString& name,
                                  const QString& toolTip) {
    auto* button = new QToolButton(row);
    button->setIcon(themeIcon(QLatin1String(icon)));
    button->setAutoRaise(true);
    button->setAccessibleName(name);
    button->setToolTip(toolTip);
    row->layout()->addWidget(button);
    return button;
}

QWidget* HelpPanel::makeBar() {
    auto* bar = new QWidget;
    auto* layout = new QHBoxLayout(bar);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    back_ = addButton(bar, "go-previous", tr("Back"), tr("To the page before (Alt+Left)"));
    forward_ = addButton(bar, "go-next", tr("Forward"), tr("To the next page (Alt+Right)"));
    contents_ = addButton(bar, "view-list-tree", tr("Contents"), tr("The list of all pages"));
    contents_->setCheckable(true);
    search_ = new QLineEdit;
    search_->setPlaceholderText(tr("Search the help"));
    search_->setClearButtonEnabled(true);
    search_->addAction(themeIcon("edit-find"), QLineEdit::LeadingPosition);
    search_->setToolTip(tr("Words that stand on a page. Down goes to the list, Enter opens"));
    search_->setAccessibleName(tr("Search the help"));
    layout->addWidget(search_, 1);
    connect(back_, &QToolButton::clicked, browser_, &HelpBrowser::backward);
    connect(forward_, &QToolButton::clicked, browser_, &HelpBrowser::forward);
    connect(contents_, &QToolButton::toggled, this, &HelpPanel::showList);
    connect(search_, &QLineEdit::textChanged, this, &HelpPanel::search);
    return bar;
}

QWidget* HelpPanel::makeList() {
    filter_->setSourceModel(pages_);
    filter_->setFilterRole(searchRole);
    filter_->setSortRole(orderRole);
    filter_->setDynamicSortFilter(false);
    filter_->setRecursiveFilteringEnabled(true);
    list_ = new QTreeView;
    list_->setModel(filter_);
    list_->setHeaderHidden(true);
    list_->setRootIsDecorated(false);
    list_->setItemsExpandable(false);
    list_->setUniformRowHeights(true);
    list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    list_->setAccessibleName(tr("Pages of the help"));
    list_->setToolTip(tr("A click or Enter opens the page"));
    noMatch_ = new QLabel(tr("No page has all these words."), list_->viewport());
    noMatch_->setForegroundRole(QPalette::PlaceholderText);
    noMatch_->setMargin(12);
    noMatch_->adjustSize();
    noMatch_->hide();
    connect(list_, &QTreeView::clicked, this, &HelpPanel::choose);
    return list_;
}

QWidget* HelpPanel::makeFindRow() {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    find_ = new QLineEdit;
    find_->setPlaceholderText(tr("Find on this page"));
    find_->setClearButtonEnabled(true);
    find_->setToolTip(tr("Enter goes to the next place, Shift+Enter to the one before"));
    find_->setAccessibleName(tr("Find on this page"));
    layout->addWidget(find_, 1);
    found_ = new QLabel;
    found_->setForegroundRole(QPalette::PlaceholderText);
    found_->setAccessibleDescription(tr("Number of places"));
    layout->addWidget(found_);
    connect(addButton(row, "go-up-search", tr("Find previous"), tr("To the place before")),
            &QToolButton::clicked, this, [this] { findOnPage(false); });
    connect(addButton(row, "go-down-search", tr("Find next"), tr("To the next place")), &QToolButton::clicked,
            this, [this] { findOnPage(true); });
    connect(find_, &QLineEdit::textChanged, this, [this] {
        // While it is typed, from where it began.
        QTextCursor cursor = browser_->textCursor();
        cursor.setPosition(cursor.selectionStart());
        browser_->setTextCursor(cursor);
        findOnPage(true);
    });
    return row;
}

void HelpPanel::fillList() {
    QStandardItem* group = nullptr;
    QString title;
    int order = 0;
    QFont bold = list_->font();
    bold.setBold(true);
    for (const HelpPage& page : library_.contents()) {
        auto* item = new QStandardItem(page.title);
        item->setData(page.address, addressRole);
        item->setData(page.title + QLatin1Char(' ') + page.text, searchRole);
        item->setData(order++, orderRole);
        if (page.group.isEmpty()) {
            pages_->appendRow(item);
            continue;
        }
        if (page.group != title || !group) {
            title = page.group;
            group = new QStandardItem(title);
            group->setFlags(Qt::ItemIsEnabled);
            group->setFont(bold);
            group->setData(order++, orderRole);
            pages_->appendRow(group);
        }
        group->appendRow(item);
    }
    filter_->sort(0);
    list_->expandAll();
}

void HelpPanel::open(const QString& address, const QString& words) {
    showList(false);
    browser_->open(address, words);
}

bool HelpPanel::listShown() const { return stack_->currentWidget() == list_; }

void HelpPanel::showList(bool shown) {
    stack_->setCurrentWidget(shown ? static_cast<QWidget*>(list_) : browser_);
    const QSignalBlocker quiet(contents_);
    contents_->setChecked(shown);
    if (shown && !list_->currentIndex().isValid()) chooseFirst();
}

void HelpPanel::search(const QString& words) {
    // Pages whose titles have the words come first.
    const QStringList parts = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    const int behind = static_cast<int>(library_.contents().size()) * 2;
    for (int i = 0; i < pages_->rowCount(); ++i)
        for (int j = 0, order = 0; j < pages_->item(i)->rowCount(); ++j, ++order) {
            QStandardItem* page = pages_->item(i)->child(j);
            const bool titled = std::ranges::all_of(parts, [page](const QString& part) {
                return page->text().contains(part, Qt::CaseInsensitive);
            });
            page->setData(titled ? order : order + behind, orderRole);
        }
    filter_->setSearch(words);
    filter_->sort(0);
    list_->expandAll();
    noMatch_->setVisible(filter_->rowCount() == 0);
    showList(true);
    chooseFirst();
}

void HelpPanel::chooseFirst() {
    QModelIndex first;
    int best = INT_MAX;
    // The best page of all groups, not the first group's.
    for (int i = 0; i < filter_->rowCount(); ++i) {
        QModelIndex row = filter_->index(i, 0);
        if (filter_->hasChildren(row)) row = filter_->index(0, 0, row);
        const bool titled = row.data(orderRole).toInt() < static_cast<int>(library_.contents().size()) * 2;
        const int rank = titled ? 0 : 1;
        if (rank < best) {
            best = rank;
            first = row;
        }
    }
    list_->setCurrentIndex(first);
    list_->scrollToTop();
    if (first.isValid()) list_->scrollTo(first);
}

void HelpPanel::choose(const QModelIndex& row) {
    const QString address = row.data(addressRole).toString();
    if (address.isEmpty()) return;
    open(address, search_->text());
    browser_->setFocus();
}

void HelpPanel::findOnPage(bool forward) {
    const QString text = find_->text();
    const int places = browser_->findText(text, forward);
    found_->setText(text.isEmpty() ? QString()
                    : places == 0  ? tr("none")
                                   : tr("%n place(s)", nullptr, places));
}

void HelpPanel::pageChanged() {
    back_->setEnabled(browser_->canGoBack());
    forward_->setEnabled(browser_->canGoForward());
    found_->clear();
}

bool HelpPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool enter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
    if (key->key() == Qt::Key_Escape && key->modifiers() == Qt::NoModifier) {
        if (listShown() && !browser_->address().isEmpty())
            showList(false);
        else
            emit focusReleased();
        return true;
    }
    if (enter && watched == find_) {
        findOnPage(!(key->modifiers() & Qt::ShiftModifier));
        return true;
    }
    if (enter && (watched == search_ || watched == list_)) {
        if (listShown()) choose(list_->currentIndex());
        return true;
    }
    const bool walking = key->key() == Qt::Key_Down || key->key() == Qt::Key_Up ||
                         key->key() == Qt::Key_PageDown || key->key() == Qt::Key_PageUp;
    if (watched == search_ && walking) {
        showList(true);
        // The list is walked through while the words stay under the fingers.
        QCoreApplication::sendEvent(list_, event);
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace isoscope
