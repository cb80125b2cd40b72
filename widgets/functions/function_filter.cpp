// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/functions/function_filter.h"

#include <string_view>
#include <utility>

#include "widgets/functions/function_list_model.h"

namespace isoscope {

FunctionFilter::FunctionFilter(QObject* parent) : WordFilter(parent) {
    setFilterRole(FunctionListModel::searchRole);
}

bool FunctionFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    return !FunctionListModel::builtin(row).name.empty() && WordFilter::filterAcceptsRow(row, parent);
}

bool FunctionFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
    const auto key = [](const QModelIndex& index) {
        const Builtin& builtin = FunctionListModel::builtin(index.row());
        return std::pair(builtin.id < 0, std::string_view(builtin.name));
    };
    return key(left) < key(right);
}

}  // namespace isoscope
