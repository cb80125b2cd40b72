// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/roots/column_table.h"
#include "core/roots/line_columns.h"

namespace isoscope::test {

/// Lines in columns.
class LineTable {
  public:
    explicit LineTable(const std::vector<LineQuery>& lines) {
        table_.reserve(lines.size());
        table_.setSize(lines.size());
        for (std::size_t i = 0; i < lines.size(); ++i) {
            for (int c = 0; c < 3; ++c) {
                table_[static_cast<std::size_t>(c)][i] = lines[i].origin[c];
                table_[static_cast<std::size_t>(c) + 3][i] = lines[i].direction[c];
            }
            table_[6][i] = lines[i].near;
            table_[7][i] = lines[i].far;
        }
    }
    LineColumns columns() const {
        return {table_.size(),
                {table_[0], table_[1], table_[2]},
                {table_[3], table_[4], table_[5]},
                table_[6],
                table_[7]};
    }

  private:
    ColumnTable<8> table_;
};

}  // namespace isoscope::test
