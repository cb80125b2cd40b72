// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

class QMainWindow;
class QToolBar;
class QToolButton;

namespace isoscope {

/// The tool bars at the top of a window, in one row. Some buttons bear words beside their icons; where the
/// row has no room for words they show their icons alone, so that no tool hides behind an arrow.
class ToolRow : public QObject {
    Q_OBJECT
  public:
    /// `worded`: the buttons with words.
    ToolRow(QMainWindow* window, const QList<QToolBar*>& bars, const QList<QToolButton*>& worded);

    /// Whether the row has room for the words at its present width.
    bool wordsShown() const { return wordsShown_; }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void fit();
    int wantedWidth() const;
    void showWords(bool shown);

    QMainWindow* window_;
    QList<QToolBar*> bars_;
    QList<QToolButton*> worded_;
    bool wordsShown_ = true;
};

}  // namespace isoscope
