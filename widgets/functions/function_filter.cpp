// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/functions/function_filter.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "widgets/functions/function_list_model.h"

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

bool FunctionFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
    const auto key = [](const QModelIndex& index) {
        const Builtin& builtin = builtins()[index.row()];
        return std::pair(builtin.id < 0, std::string_view(builtin.name));
    };
    return key(left) < key(right);
}

}  // namespace isoscope
