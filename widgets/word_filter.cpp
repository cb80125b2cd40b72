// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/word_filter.h"

#include <algorithm>

namespace isoscope {

void WordFilter::setSearch(const QString& text) {
    words_ = text.split(' ', Qt::SkipEmptyParts);
    invalidateFilter();
}

bool WordFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    const QString text = sourceModel()->index(row, 0, parent).data(filterRole()).toString();
    return std::ranges::all_of(
        words_, [&text](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

}  // namespace isoscope
