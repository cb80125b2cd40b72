// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QWidget>

#include "widgets/gallery/gallery_entry.h"

class QLabel;
class QLineEdit;
class QListView;
class QMenu;
class QModelIndex;
class QPushButton;

namespace isoscope {

class WordFilter;
class GalleryModel;

/// Scenes with their pictures, to be searched and opened. Knows neither where entries come from nor what
/// opening does.
class GalleryPanel : public QWidget {
    Q_OBJECT
  public:
    /// Small entries with a line each for a panel, or larger ones with their whole sentence for a page.
    enum class Kind { panel, page };
    explicit GalleryPanel(QWidget* parent = nullptr, Kind kind = Kind::panel);

    /// Takes the place of all entries; the search stays.
    void setEntries(QList<GalleryEntry> entries);
    /// Shows and focuses the search field.
    void startSearch();
    GalleryModel* model() const { return model_; }

  signals:
    /// For the first time: entries are wanted.
    void firstShown();
    /// Clicked, or Enter.
    void openRequested(const isoscope::GalleryEntry& entry);
    /// The isosurface of the entry's function is wanted in the text.
    void insertRequested(const isoscope::Builtin* builtin);
    /// The open text is to be kept; the entry is one of the own collection that is to go.
    void addRequested();
    void removeRequested(const isoscope::GalleryEntry& entry);
    /// The entry of the own collection is to be called so.
    void renameRequested(const isoscope::GalleryEntry& entry, const QString& title);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

  private:
    void build(Kind kind);
    void showMatches();
    void open(const QModelIndex& index);
    void showMenu(const QPoint& at);
    void fillMenu(QMenu* menu, const QModelIndex& index);
    const GalleryEntry* entryAt(const QModelIndex& index) const;

    GalleryModel* model_ = nullptr;
    WordFilter* filter_ = nullptr;
    QLineEdit* search_ = nullptr;
    QListView* list_ = nullptr;
    QLabel* noMatch_ = nullptr;
    QPushButton* add_ = nullptr;
    bool shown_ = false;
};

}  // namespace isoscope
