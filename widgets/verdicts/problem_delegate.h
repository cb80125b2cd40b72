// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace isoscope {

/// Draws a problem: the message, and below it, softer, the hint where there is one, both with their code
/// words in the font of code. What is wider than the column takes several lines. An index widget, the row's
/// buttons, gets a line of its own below.
class ProblemDelegate : public QStyledItemDelegate {
    Q_OBJECT
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    /// The message and the hint with their code words between backticks; the item's own text is for those who
    /// cannot see the difference.
    static constexpr int messageRole = Qt::UserRole + 1;
    static constexpr int hintRole = Qt::UserRole + 2;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;
};

}  // namespace isoscope
