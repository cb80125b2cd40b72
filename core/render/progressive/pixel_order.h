// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace isoscope {

/// In which order the cells of a tile are drawn.
enum class PixelOrder {
    rows,     ///< as POV-Ray does: its memory of the last miss depends on it
    squares,  ///< 2 x 2 at a time, four of these 4 x 4, and four of those 8 x 8: consecutive rays make narrow
              ///< bundles (BundleMarch)
};

/// Calls visit(column, row) for every cell of a grid.
template <class Visit>
void visitCells(int columns, int rows, PixelOrder order, Visit visit) {
    const auto visitSquares = [](int left, int top, int right, int bottom, int side, auto inner) {
        for (int y = top; y < bottom; y += side)
            for (int x = left; x < right; x += side)
                inner(x, y, std::min(x + side, right), std::min(y + side, bottom));
    };
    const auto visitRows = [&](int left, int top, int right, int bottom) {
        visitSquares(left, top, right, bottom, 1, [&](int x, int y, int, int) { visit(x, y); });
    };
    if (order == PixelOrder::rows) return visitRows(0, 0, columns, rows);
    visitSquares(0, 0, columns, rows, 8, [&](int left, int top, int right, int bottom) {
        visitSquares(left, top, right, bottom, 4,
                     [&](int x, int y, int endX, int endY) { visitSquares(x, y, endX, endY, 2, visitRows); });
    });
}

}  // namespace isoscope
