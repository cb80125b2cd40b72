// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QStringList>
#include <vector>

#include "widgets/document/recovery_store.h"

class QLabel;
class QListWidget;
class QPlainTextEdit;
class QPushButton;

namespace isoscope {

/// "heart.pov", or "A new scene" for a text without a file.
QString keptName(const UnsavedText& text);

/// The unsaved texts that were kept, newest first: name, date and first lines, to bring back or to discard.
/// Not modal; acting is the caller's business, who then calls show(texts) again.
class KeptTextsWindow : public QDialog {
    Q_OBJECT
  public:
    explicit KeptTextsWindow(QWidget* parent);

    /// The texts that are listed, newest first; a new list keeps the selected row. count() is their number.
    void setTexts(std::vector<UnsavedText> texts);
    int count() const { return static_cast<int>(texts_.size()); }

  signals:
    /// A button asks to open the selected text, or to delete these; the list stays as it is. Ids are those of
    /// UnsavedText.
    void bringBackRequested(const QString& id);
    void discardRequested(const QStringList& ids);

  private:
    void showPreview();
    void askWhetherAll(bool asking);
    QString currentId() const;

    std::vector<UnsavedText> texts_;
    QLabel* summary_;
    QListWidget* list_;
    QLabel* place_;
    QPlainTextEdit* preview_;
    QPushButton *bringBack_, *discard_, *discardAll_;
    bool asking_ = false;  ///< the next press discards all
};

}  // namespace isoscope
