// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/function_filter.h"

#include <algorithm>

#include "widgets/function_list_model.h"

namespace isoscope {

void FunctionFilter::setSearch(const QString& text) {
    words_ = text.split(' ', Qt::SkipEmptyParts);
    invalidateFilter();
}

bool FunctionFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    if (builtins()[row].name.empty()) return false;
    const QString text = sourceModel()->index(row, 0, parent).data(FunctionListModel::searchRole).toString();
    return std::all_of(words_.begin(), words_.end(),
                       [&text](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

}  // namespace isoscope
