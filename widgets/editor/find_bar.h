// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

#include "widgets/editor/text_search.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QToolButton;

namespace isoscope {

class SceneEditor;

/// Find and replace below the editor, never modal. Hidden until showFind() or showReplace(); Escape hides it
/// and gives the focus back to the editor. All matches are marked in the text and counted while typing.
class FindBar : public QWidget {
    Q_OBJECT
  public:
    /// The editor must outlive the bar.
    explicit FindBar(SceneEditor* editor, QWidget* parent = nullptr);
    ~FindBar() override;

  public slots:
    /// Ctrl+F: the selection, when it lies in one line, is what to look for.
    void showFind();
    /// Ctrl+H
    void showReplace();
    void hideBar();
    /// F3 and Shift+F3: go round at the ends.
    void findNext();
    void findPrevious();
    /// Replaces the selected match and goes to the next one.
    void replaceOne();
    /// One undo step.
    void replaceAll();

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void build();
    void buildFindRow();
    void buildReplaceRow();
    void open(bool withReplace);
    void textTyped();
    void search();
    void select(int index);
    void step(bool forward);
    void showCount();
    void markAll();

    SceneEditor* editor_;
    QLineEdit* pattern_ = nullptr;
    QLineEdit* replacement_ = nullptr;
    QWidget* findRow_ = nullptr;
    QWidget* replaceRow_ = nullptr;
    QToolButton* caseSensitive_ = nullptr;
    QToolButton* wholeWord_ = nullptr;
    QToolButton* regular_ = nullptr;
    QLabel* count_ = nullptr;
    QToolButton* next_ = nullptr;
    QToolButton* previous_ = nullptr;
    QPushButton* replaceOne_ = nullptr;
    QPushButton* replaceAll_ = nullptr;
    SearchResult result_;
    QTimer searchLater_;
    int current_ = -1;
    long typedFrom_ = 0;  // where the search begins while the pattern is being typed
};

}  // namespace isoscope
