// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QToolButton;
class QVBoxLayout;

namespace isoscope {

/// The rows of one call under a heading that folds them.
class ParameterGroup : public QWidget {
    Q_OBJECT
  public:
    explicit ParameterGroup(QWidget* parent = nullptr);

    /// The call or statement that the rows belong to; also in the tooltip and for screen readers.
    void setTitle(const QString& title);
    /// Puts the rows in this order; they become children of the group.
    void setRows(const QList<QWidget*>& rows);
    /// Whether any row is not hidden by itself.
    bool hasShownRows() const;

  private:
    QToolButton* heading_;
    QWidget* body_;
    QVBoxLayout* rows_;
};

}  // namespace isoscope
