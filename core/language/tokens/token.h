// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/text/source_text.h"

namespace isoscope {

/// What a Token is, and which member of it counts.
enum class TokenKind {
    number,  ///< Token::number
    string,  ///< Token::string, escapes resolved
    word,    ///< a keyword or identifier; case matters
    symbol,  ///< punctuation: one of  { } ( ) < > [ ] , ; . + - * / & | = ! ? : ^ ~ and <= >= !=; the Lexer
             ///< gives # too
    end,     ///< end of the whole input
};

/// One token of the scene language. `text` points into the SourceLibrary and lives as long as it.
struct Token {
    TokenKind kind = TokenKind::end;
    std::string_view text;
    double number = 0;
    std::string string;
    SourceRange range;

    /// Whether it is this word or symbol, case included; false for numbers, strings and the end.
    bool is(std::string_view wordOrSymbol) const {
        // Most questions are answered by the first character; this is the hottest line of the parser.
        return (kind == TokenKind::word || kind == TokenKind::symbol) && text.size() == wordOrSymbol.size() &&
               !text.empty() && text.front() == wordOrSymbol.front() && text == wordOrSymbol;
    }
};

}  // namespace isoscope
