// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSortFilterProxyModel>
#include <QStringList>

namespace isoscope {

/// Numbered functions first, then the patterns, by name. Leaves the functions that have a name (internal(77)
/// cannot be called) and hold every word of the search in their name, kind or parameter names.
class FunctionFilter : public QSortFilterProxyModel {
    Q_OBJECT
  public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    /// The words searched for, divided by spaces, in any order; an empty text leaves all named functions.
    void setSearch(const QString& text);

  protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
    bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

  private:
    QStringList words_;
};

}  // namespace isoscope
