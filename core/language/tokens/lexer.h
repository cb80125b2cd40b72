// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "core/language/tokens/token.h"
#include "core/text/diagnostic.h"

namespace isoscope {

/// Cuts one text, or a piece of it, into words, numbers, strings and symbols. Directives are not its
/// business: `#` is a symbol like any other. Any bytes are accepted; what cannot begin a token is passed over
/// and told by `takeMistake`. Holds no memory of its own, so that loops and macros can read the same text
/// again by `seek`.
class Lexer {
  public:
    /// Reads bytes [begin, end) of `text`, which is text number `file`; the token ranges refer to it.
    Lexer(std::string_view text, std::uint32_t file, std::uint32_t begin, std::uint32_t end);
    Lexer(std::string_view text, std::uint32_t file);

    /// The next token; at the end, `TokenKind::end` again and again. Strings keep their escapes:
    /// Token::string is left empty (see decodeString), because file names want the backslashes.
    Token next();

    /// Where the next token is looked for.
    std::uint32_t offset() const { return position_; }
    void seek(std::uint32_t offset) { position_ = offset; }
    std::uint32_t file() const { return file_; }

    /// The mistake found since the last call, without its reachedFrom; null when there was none.
    std::shared_ptr<Diagnostic> takeMistake() { return std::move(mistake_); }

  private:
    void skipBlank();
    void skipLineComment();
    void skipBlockComment();
    void skipStrayBytes();
    Token readNumber();
    Token readString();
    Token readWord();
    Token readSymbol();
    Token make(TokenKind kind, std::uint32_t begin) const;
    char at(std::uint32_t offset) const { return offset < end_ ? text_[offset] : '\0'; }
    void blame(const char* id, std::uint32_t begin, std::uint32_t end, std::string message,
               std::string hint = {});

    std::string_view text_;
    std::uint32_t file_;
    std::uint32_t position_;
    std::uint32_t end_;
    std::shared_ptr<Diagnostic> mistake_;  ///< seldom there, so it costs a pointer only
};

/// The characters that the text of a string token, quotes included, stands for. An unknown escape is kept as
/// it is and its place within `quoted` is returned in `badEscape`.
std::string decodeString(std::string_view quoted, std::optional<std::uint32_t>& badEscape);

/// What stands between the quotes of a string token, escapes untouched: a file name.
std::string_view rawString(std::string_view quoted);

}  // namespace isoscope
