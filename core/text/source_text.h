// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// A piece of a source text: bytes [begin, end) of the UTF-8 text number `file` of a SourceLibrary.
/// Byte offsets are also the editor's positions, so no conversion is needed between the two.
struct SourceRange {
    std::uint32_t file = 0;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;

    friend bool operator==(const SourceRange&, const SourceRange&) = default;
};

/// Line and column, both counted from 1; columns count bytes.
struct LineColumn {
    int line = 1;
    int column = 1;
};

/// One text (the user's, or an include file) with its name and the beginnings of its lines.
class SourceText {
  public:
    SourceText(std::string name, std::string text);

    /// The name that diagnostics print before the line: a file's path, or what the caller called the text.
    const std::string& name() const { return name_; }
    /// The whole text as it was given; valid while the object lives.
    std::string_view text() const { return text_; }
    /// The position of a byte offset; offsets behind the end give the position of the end.
    LineColumn position(std::uint32_t offset) const;

  private:
    std::string name_;
    std::string text_;
    std::vector<std::uint32_t> lineStarts_;
};

/// Every text that one parse has read, in the order of reading; number 0 is the user's own.
/// References stay valid while the library lives.
class SourceLibrary {
  public:
    /// Takes a text in; its number, as in SourceRange::file, is how many there were before.
    std::uint32_t add(std::string name, std::string text);
    const SourceText& operator[](std::uint32_t file) const { return texts_[file]; }
    /// Texts taken in so far. Numbers from here on belong to none; operator[] does not check.
    std::size_t size() const { return texts_.size(); }
    /// The text of a range; empty for a range outside the library.
    std::string_view slice(const SourceRange& range) const;

  private:
    std::deque<SourceText> texts_;
};

}  // namespace isoscope
