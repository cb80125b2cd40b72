// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace isoscope {

/// In which order the cells of a tile are drawn.
enum class PixelOrder {
    rows,     ///< as POV-Ray does: its memory of the last miss depends on it
    squares,  ///< 4 x 4 at a time, so that consecutive rays make narrow bundles (BundleMarch)
};

/// Calls visit(column, row) for every cell of a grid.
template <class Visit>
void visitCells(int columns, int rows, PixelOrder order, Visit visit) {
    const int side = order == PixelOrder::squares ? 4 : std::max(columns, rows);
    for (int top = 0; top < rows; top += side)
        for (int left = 0; left < columns; left += side)
            for (int row = top; row < std::min(top + side, rows); ++row)
                for (int column = left; column < std::min(left + side, columns); ++column) visit(column, row);
}

}  // namespace isoscope
