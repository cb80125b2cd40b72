// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/word_filter.h"

namespace isoscope {

/// Numbered functions first, then the patterns, by name. Leaves the functions that have a name (internal(77)
/// cannot be called) and hold every word of the search in their name, kind or parameter names.
class FunctionFilter : public WordFilter {
    Q_OBJECT
  public:
    explicit FunctionFilter(QObject* parent = nullptr);

  protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
    bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;
};

}  // namespace isoscope
