// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/render/image.h"

namespace isoscope {

/// Small pictures in rows and columns, each with a label below it.
class PictureSheet {
  public:
    /// Pictures of this size, so many in a row; all positive.
    PictureSheet(int columns, int rows, int width, int height);

    /// Of the whole sheet, in pixels.
    int width() const { return image_.width; }
    int height() const { return image_.height; }
    /// Pixels of a sheet of that size, for callers that have to refuse too large ones; no overflow.
    static double pixels(int columns, int rows, int width, int height);

    /// Puts a picture, which is clipped to its place, and its label there. Labels show digits, blanks and the
    /// signs `.-+e=,`; every other character is a blank.
    void put(int column, int row, const Image& picture, const std::string& label);
    const Image& image() const { return image_; }
    /// The column and row whose picture or label is at a pixel; nothing between pictures and outside.
    std::optional<std::pair<int, int>> placeAt(int x, int y) const;

  private:
    void write(int left, int top, const std::string& label);

    int columns_, rows_, width_, height_, scale_;
    Image image_;
};

}  // namespace isoscope
