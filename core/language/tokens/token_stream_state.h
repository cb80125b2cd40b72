// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/language/directives/include_library.h"
#include "core/language/tokens/lexer.h"
#include "core/language/tokens/token_stream.h"

namespace isoscope {

/// A block of directives that is open: `#if`, `#while`, `#for` or `#switch`, waiting for its `#end`.
struct DirectiveBlock {
    /// The word that opened the block; `#ifdef`, `#ifndef` and `#else` are of the first kind.
    enum class Kind { conditional, whileLoop, forLoop, switchCase };

    Kind kind = Kind::conditional;
    SourceRange range;        ///< the directive's `#` and word
    std::uint32_t again = 0;  ///< of loops: where the condition (`#while`) or the body (`#for`) begins
    std::string variable;     ///< of `#for`
    double last = 0, step = 1;
    std::size_t rounds = 0;

    /// Whether `#end` may lead back to `again`.
    bool isLoop() const { return kind == Kind::whileLoop || kind == Kind::forLoop; }
};

/// A text that is being read: the scene, an include file or a macro's body. Blocks do not reach beyond it.
struct TokenFrame {
    Lexer lexer;
    bool isMacro = false;
    SourceRange callSite;
    std::vector<DirectiveBlock> blocks;
};

/// Everything that a TokenStream knows of its position: for the readers of directives and macros, which are
/// its friends.
struct TokenStream::State {
    explicit State(ParseContext& context) : includes(context) {}

    /// How much of a directive's value has been taken; DirectiveScope::beginValue starts anew.
    struct Reach {
        bool stopWhenComplete = false;
        int depth = 0;          ///< open braces, brackets and parentheses
        bool complete = false;  ///< the token taken last can end a value

        /// Follows a token that the parser takes, or puts back.
        void take(const Token& token);
        void giveBack(const Token& token);
        /// Whether the tokens taken form a whole value: a directive or macro behind it is not part of it.
        bool stopped() const { return stopWhenComplete && complete && depth <= 0; }
    };

    std::vector<TokenFrame> frames;
    /// The next token is passed over if it is a `;`: POV-Ray takes two behind the number or vector of a
    /// `#declare`, the first of which may be the last token of a macro.
    bool spareSemicolon = false;
    std::vector<Token> ahead;  ///< tokens to be given next, the last one first
    std::size_t floor =
        0;  ///< the directive at hand began in this frame and may not read on in the one below
    bool inDirective = false;
    std::size_t blocksBefore = 0;  ///< blocks that were open in the floor frame when the directive began
    Reach reach;
    SourceRange lastRange;
    std::size_t steps = 0;
    bool cutOff = false;
    std::size_t macroDepth = 0;
    ValueParser valueParser;
    DefaultParser defaultParser;
    IncludeLibrary includes;
    /// TokenStream::missingBraces() by text.
    std::map<std::uint32_t, std::ptrdiff_t> missingBraces;
    /// Where braces have been supplied, as text and place: loops and macros find them there each time.
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> closings;
    std::set<std::pair<std::uint32_t, std::uint32_t>> openings;
    int suppliedHere = 0;  ///< how many closing ones at the token at hand
};

/// While it lives, tokens are read for a directive (or a macro call) that began in the innermost frame;
/// afterwards the state of the directive or statement around it is back.
class DirectiveScope {
  public:
    explicit DirectiveScope(TokenStream& tokens);
    ~DirectiveScope();
    DirectiveScope(const DirectiveScope&) = delete;
    DirectiveScope& operator=(const DirectiveScope&) = delete;

    /// From here on the tokens form one value, behind which the stream seems to end.
    void beginValue();
    /// Back to the frame in which the directive began, right behind the token taken last.
    void settle();

  private:
    TokenStream& tokens_;
    std::size_t floor_;
    bool inDirective_;
    std::size_t blocksBefore_;
    TokenStream::State::Reach reach_;
};

}  // namespace isoscope
