// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/exchange/sheets/picture_sheet.h"
#include "core/exchange/varied_number.h"
#include "core/render/render_request.h"

namespace isoscope {

/// A number of the scene with the values that it is to have.
struct VariedNumber {
    std::size_t parameter = 0;  ///< its number among the scene's parameters
    std::vector<double> values;
};

/// The scene in small, once for each value of a number, or of two: the first goes across, the second down.
class SmallMultiples {
  public:
    /// One picture of the sheet.
    struct Cell {
        int column = 0, row = 0;
        std::vector<NumberSetting> numbers;
        std::string label;  ///< the values, four digits each
    };
    /// Largest sheet, in pixels.
    static constexpr double mostPixels = 100e6;

    /// `columns` counts for one number only: pictures in a row, 0 for about as many as there are rows. `view`
    /// has size, camera and method of each picture; its scene is not used. With `ownCamera` the camera is
    /// that of the scene with the numbers set.
    SmallMultiples(const ParseResult& parsed, RenderRequest view, bool ownCamera, VariedNumber first,
                   std::optional<VariedNumber> second = {}, int columns = 0);

    /// The pictures, row by row, and how many go across and down.
    const std::vector<Cell>& cells() const { return cells_; }
    int columns() const { return columns_; }
    int rows() const { return rows_; }
    /// Larger sheets than mostPixels are not drawn: draw() must not be called.
    bool tooLarge() const;

    /// Draws cell `index` into the sheet; false where the scene cannot be read with these values, or after a
    /// stop: the place stays empty. `threads` 0 means all.
    bool draw(std::size_t index, std::stop_token stop = {}, int threads = 0);
    /// What is drawn so far.
    const PictureSheet& sheet() const { return *sheet_; }

  private:
    const ParseResult& parsed_;
    RenderRequest view_;
    bool ownCamera_;
    std::vector<Cell> cells_;
    int columns_ = 1, rows_ = 1;
    std::optional<PictureSheet> sheet_;
};

}  // namespace isoscope
