// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <vector>

class QLabel;
class QPlainTextEdit;

namespace isoscope {

struct DifferenceLine;

/// Shows how the text on the disk differs from the one in the editor, line by line with three lines around
/// each difference, and offers which one to go on with. Not modal; the choice is the caller's to act on.
class DifferenceWindow : public QDialog {
    Q_OBJECT
  public:
    DifferenceWindow(const QString& name, const QString& onDisk, const QString& here, QWidget* parent);

    /// The lines as they are shown, "- " before those that only the disk has and "+ " before those that stand
    /// only here.
    QString shownText() const;

  signals:
    /// A button was pressed: go on with the text on the disk, or with the one in the editor. The window
    /// closes.
    void takeTheirs();
    void keepMine();

  private:
    void showLines(const std::vector<DifferenceLine>& lines);

    QLabel* summary_;
    QPlainTextEdit* text_;
};

}  // namespace isoscope
