// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "core/roots/column_table.h"

namespace isoscope {

/// The part of each ray's line that lies in a convex solid, column by column: between `in` and `out`, which
/// are infinite where the solid is endless; `in` is infinite and `out` minus infinite where the line misses.
/// Normals are those of the solid at both ends. Where `doubt` is not 0 the rest is meaningless, and where it
/// is 0 the line passes by no border of the solid so near that rounding decides what is inside.
/// Keeps its memory.
class SpanBatch {
  public:
    /// The columns that operator[] hands out; in and out are values of t.
    enum Column : std::size_t { in, out, doubt, inX, inY, inZ, outX, outY, outZ, columnCount };

    /// Makes room for so many rays, whose entries are for the caller to write.
    void setSize(std::size_t rays) {
        columns_.reserve(rays);
        columns_.setSize(rays);
    }

    double* operator[](Column column) { return columns_[column]; }
    const double* operator[](Column column) const { return columns_[column]; }
    /// The columns of x, y and z of the normals, of unit length, at `in` and at `out`. Valid until setSize().
    std::array<double*, 3> inNormals() { return {columns_[inX], columns_[inY], columns_[inZ]}; }
    std::array<double*, 3> outNormals() { return {columns_[outX], columns_[outY], columns_[outZ]}; }

  private:
    ColumnTable<columnCount> columns_;
};

}  // namespace isoscope
