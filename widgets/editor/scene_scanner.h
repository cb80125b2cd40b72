// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/language/parse.h"

namespace isoscope {

/// The colour classes of the editor; also Scintilla's style numbers.
enum class SceneStyle { plain, comment, string, number, directive, keyword, function, symbol, count };

/// Cuts a scene text into coloured pieces, line by line: the only state between lines is how deep the block
/// comments are nested. Works on UTF-8 bytes and accepts any of them.
class SceneScanner {
  public:
    /// Bytes of one style, in the order of the text.
    struct Piece {
        int length = 0;
        SceneStyle style = SceneStyle::plain;
    };

    /// `commentDepth` is what depth() was at the end of the text before.
    SceneScanner(std::string_view text, int commentDepth, Notation notation = Notation::povray)
        : text_(text), depth_(commentDepth), notation_(notation) {}

    /// Whether next() has nothing more; position() is the byte offset at which its next piece begins.
    bool atEnd() const { return position_ >= text_.size(); }
    std::size_t position() const { return position_; }
    /// The next piece; never crosses a line end, so that depth() is right at every one.
    Piece next();
    int depth() const { return depth_; }

  private:
    Piece piece(std::size_t end, SceneStyle style);
    std::size_t commentEnd();
    std::size_t stringEnd() const;
    std::size_t numberEnd() const;
    std::size_t wordEnd(std::size_t begin) const;
    char at(std::size_t position) const { return position < text_.size() ? text_[position] : '\0'; }

    std::string_view text_;
    std::size_t position_ = 0;
    int depth_ = 0;
    Notation notation_;
};

}  // namespace isoscope
