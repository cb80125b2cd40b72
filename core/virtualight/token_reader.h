// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <string>
#include <string_view>

#include "core/language/parse_context.h"
#include "core/language/tokens/lexer.h"

namespace isoscope::virtualight {

/// The tokens of a VirtuaLight text, which has no directives, loops or macros: what is read is the text
/// itself, once. The end token comes again and again. Mistakes of the lexer are reported to the context.
class TokenReader {
  public:
    TokenReader(ParseContext& context, std::uint32_t file);

    /// The token `ahead` places behind the next one, without taking it.
    const Token& peek(std::size_t ahead = 0);
    Token next();
    /// Takes the next token if it is this word or symbol.
    bool accept(std::string_view wordOrSymbol);
    /// Takes it or reports "expected `]` ...": `purpose` completes the sentence ("to close `Shape`").
    bool expect(std::string_view wordOrSymbol, std::string_view purpose);
    /// How many brackets are open. A closing one closes those opened after its own kind too.
    std::size_t depth() const { return open_.size(); }
    /// Skips until `depth` brackets are open, but not the bracket that would close more.
    void skipTo(std::size_t depth);
    /// Skips what may belong to one unknown item: words up to one pair of brackets and what is in it.
    void skipItem();
    /// Ends the reading with an error, once.
    void cut(std::string id, const SourceRange& range, std::string message, std::string hint = {});

    /// Diagnostics and options of this parse.
    ParseContext& context() { return context_; }
    /// Range of the token taken last; empty, at the beginning, before any.
    const SourceRange& lastRange() const { return lastRange_; }
    /// From the beginning of `first` to the token taken last.
    SourceRange rangeFrom(const SourceRange& first) const;

  private:
    Token read();
    /// The number of open brackets that the token leaves.
    std::size_t depthBehind(const Token& token) const;

    ParseContext& context_;
    Lexer lexer_;
    std::deque<Token> ahead_;
    SourceRange lastRange_;
    std::string open_;  ///< the opening brackets
    bool cut_ = false;
};

/// Counts brackets and operators inside one another while it lives; beyond `limit` reading is cut off, so
/// that no text uses up the parser's own stack.
class Nesting {
  public:
    static constexpr int limit = 200;

    explicit Nesting(TokenReader& tokens);
    ~Nesting() { --context_.nesting; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;

    /// False beyond the limit: the parser returns without going deeper.
    bool ok() const { return context_.nesting <= limit; }

  private:
    ParseContext& context_;
};

/// "`foo`", "a string", "the end of the text".
std::string described(const Token& token);

}  // namespace isoscope::virtualight
