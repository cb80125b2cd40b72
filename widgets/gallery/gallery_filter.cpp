// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/gallery/gallery_filter.h"

#include <algorithm>

#include "widgets/gallery/gallery_model.h"

namespace isoscope {

void GalleryFilter::setSearch(const QString& text) {
    words_ = text.split(' ', Qt::SkipEmptyParts);
    invalidateFilter();
}

bool GalleryFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    const QString text = sourceModel()->index(row, 0, parent).data(GalleryModel::searchRole).toString();
    return std::ranges::all_of(
        words_, [&text](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

}  // namespace isoscope
