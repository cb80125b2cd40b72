// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QWidget>

#include "widgets/gallery/gallery_entry.h"

class QLabel;
class QLineEdit;
class QListView;
class QPushButton;

namespace isoscope {

class WordFilter;
class GalleryModel;

/// Scenes with their pictures, to be searched and opened. Knows neither where entries come from nor what
/// opening does.
class GalleryPanel : public QWidget {
    Q_OBJECT
  public:
    explicit GalleryPanel(QWidget* parent = nullptr);

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

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

  private:
    void build();
    void showMatches();
    void open(const QModelIndex& index);
    void showMenu(const QPoint& at);
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
