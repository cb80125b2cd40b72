// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/gallery/gallery_panel.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "widgets/gallery/gallery_delegate.h"
#include "widgets/gallery/gallery_model.h"
#include "widgets/icons.h"
#include "widgets/word_filter.h"

namespace isoscope {

GalleryPanel::GalleryPanel(QWidget* parent, Kind kind) : QWidget(parent) {
    build(kind);
    setAccessibleName(tr("Gallery"));
    connect(search_, &QLineEdit::textChanged, this, [this](const QString& text) {
        filter_->setSearch(text);
        showMatches();
    });
    connect(list_, &QListView::clicked, this, &GalleryPanel::open);
    connect(list_, &QListView::customContextMenuRequested, this, &GalleryPanel::showMenu);
    connect(add_, &QPushButton::clicked, this, &GalleryPanel::addRequested);
    connect(model_, &GalleryModel::renamed, this, [this](int row, const QString& title) {
        // A copy: what renames it changes the list.
        emit renameRequested(GalleryEntry(model_->entry(row)), title);
    });
    search_->installEventFilter(this);
    list_->installEventFilter(this);
}

void GalleryPanel::build(Kind kind) {
    model_ = new GalleryModel(this);
    filter_ = new WordFilter(this);
    filter_->setFilterRole(GalleryModel::searchRole);
    filter_->setSourceModel(model_);
    search_ = new QLineEdit(this);
    search_->setPlaceholderText(tr("Search the gallery"));
    search_->setClearButtonEnabled(true);
    search_->addAction(themeIcon("edit-find"), QLineEdit::LeadingPosition);
    search_->setToolTip(tr("Words of title, sentence or kind. Down goes to the list, Enter opens"));
    search_->setAccessibleName(tr("Search the gallery"));

    list_ = new QListView(this);
    list_->setModel(filter_);
    list_->setItemDelegate(new GalleryDelegate(
        kind == Kind::page ? GalleryDelegate::Size::large : GalleryDelegate::Size::small, list_));
    list_->setViewMode(QListView::IconMode);
    list_->setMovement(QListView::Static);
    list_->setResizeMode(QListView::Adjust);
    list_->setUniformItemSizes(true);
    list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    list_->setToolTip(tr("A click or Enter opens the scene"));
    list_->setAccessibleName(tr("Scenes of the gallery"));
    noMatch_ = new QLabel(tr("No scene matches the search."), list_->viewport());
    noMatch_->setForegroundRole(QPalette::PlaceholderText);
    noMatch_->setMargin(12);
    noMatch_->hide();

    add_ = new QPushButton(tr("Add to My Collection"), this);
    add_->setToolTip(tr("Keep the open text in the gallery"));
    add_->setAccessibleName(add_->text());

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addWidget(search_);
    layout->addWidget(list_, 1);
    layout->addWidget(add_, 0, Qt::AlignLeft);
}

void GalleryPanel::setEntries(QList<GalleryEntry> entries) {
    model_->setEntries(std::move(entries));
    showMatches();
}

void GalleryPanel::startSearch() {
    show();
    search_->setFocus(Qt::ShortcutFocusReason);
    search_->selectAll();
}

void GalleryPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (std::exchange(shown_, true)) return;
    emit firstShown();
    // Not before anybody looks: pictures cost time that the start of the program has better use for.
    model_->startPictures(devicePixelRatioF());
}

void GalleryPanel::showMatches() {
    const bool any = filter_->rowCount() > 0;
    if (any && !list_->currentIndex().isValid()) list_->setCurrentIndex(filter_->index(0, 0));
    noMatch_->setVisible(!any);
    noMatch_->adjustSize();
}

const GalleryEntry* GalleryPanel::entryAt(const QModelIndex& index) const {
    return index.isValid() ? &model_->entry(filter_->mapToSource(index).row()) : nullptr;
}

void GalleryPanel::open(const QModelIndex& index) {
    // A copy: what opens it may change the list.
    if (const GalleryEntry* entry = entryAt(index)) emit openRequested(GalleryEntry(*entry));
}

void GalleryPanel::showMenu(const QPoint& at) {
    // From the keyboard it is about the current entry, wherever the view says that the menu was asked for.
    const QModelIndex under = list_->indexAt(at), current = list_->currentIndex();
    const bool mouse = QGuiApplication::mouseButtons() != Qt::NoButton || under == current;
    const QModelIndex index = mouse ? under : current;
    if (!entryAt(index)) return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    fillMenu(menu, index);
    menu->popup(list_->viewport()->mapToGlobal(mouse ? at : list_->visualRect(index).center()));
}

void GalleryPanel::fillMenu(QMenu* menu, const QModelIndex& index) {
    const GalleryEntry entry = *entryAt(index);
    menu->addAction(tr("&Open"), this, [this, entry] { emit openRequested(entry); });
    if (entry.builtin)
        menu->addAction(tr("&Insert Isosurface"), this,
                        [this, entry] { emit insertRequested(entry.builtin); });
    if (entry.kind != GalleryEntry::Kind::own) return;
    menu->addAction(tr("Re&name"), this,
                    [this, place = QPersistentModelIndex(index)] { list_->edit(place); });
    menu->addAction(tr("&Remove from My Collection"), this, [this, entry] { emit removeRequested(entry); });
}

bool GalleryPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        open(list_->currentIndex());
        return true;
    }
    if (watched == search_ &&
        (key == Qt::Key_Down || key == Qt::Key_Up || key == Qt::Key_PageDown || key == Qt::Key_PageUp)) {
        // The list is walked through while the words stay under the fingers.
        QCoreApplication::sendEvent(list_, event);
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace isoscope
