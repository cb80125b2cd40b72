// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "core/numeric/aligned_column.h"
#include "core/roots/line_columns.h"

namespace isoscope {

/// A table of numbers, column by column, so that vector instructions can work on it. Every column goes on for
/// LineColumns::padding entries behind the last row. Keeps its memory.
template <std::size_t count>
class ColumnTable {
  public:
    /// Rows in use. clear() keeps the memory and what stands in it.
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    void clear() { size_ = 0; }

    /// Makes room for so many rows; those that are there stay.
    void reserve(std::size_t rows) {
        if (rows + LineColumns::padding <= columns_[0].size()) return;
        for (AlignedColumn& column : columns_) column.resize(rows + LineColumns::padding);
    }
    /// Makes so many rows count, at most as many as are reserved; new ones hold what stood there.
    void setSize(std::size_t rows) { size_ = rows; }

    double* operator[](std::size_t column) { return columns_[column].data(); }
    const double* operator[](std::size_t column) const { return columns_[column].data(); }

  private:
    std::array<AlignedColumn, count> columns_;
    std::size_t size_ = 0;
};

}  // namespace isoscope
