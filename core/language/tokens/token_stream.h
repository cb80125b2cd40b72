// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/language/parse_context.h"
#include "core/language/tokens/token.h"

namespace isoscope {

/// The tokens of a scene after directives: `#include`d texts, chosen branches, loop rounds and macro bodies
/// follow one another as if they had been written out; `#declare` and the like take effect as they are
/// passed. Directives may stand anywhere, inside a function body too. Never throws; a mistake in a directive
/// is reported and skipped. When the step budget is spent, or the input is nested too deeply, it says so once
/// and ends.
class TokenStream {
  public:
    /// Parses what follows `#declare NAME =` when it is no float, vector, colour or string expression: a
    /// `function`, `texture`, `object`, `isosurface`, ... The word at hand has not been read yet. Empty when
    /// it is unknown.
    using ValueParser = std::function<std::optional<Value>(TokenStream&)>;
    /// `#default { ... }`: reads the block, braces included.
    using DefaultParser = std::function<void(TokenStream&)>;

    /// Starts at the beginning of text number `file` of the context's library.
    TokenStream(ParseContext& context, std::uint32_t file);
    ~TokenStream();

    /// To be set before the first token; what they capture must live as long as tokens are read. Without them
    /// values of `#declare` other than expressions are unknown, and `#default` is skipped.
    void setValueParser(ValueParser parser);
    void setDefaultParser(DefaultParser parser);

    /// The next token, without taking it.
    const Token& peek();
    /// Takes the next token; at the end, the end token again and again.
    Token next();
    /// The same without calling the macro that the token may name: for `defined(NAME)` and the names of
    /// directives. Nothing may have been peeked at.
    Token nextName();
    /// Puts a token back, to be read again next.
    void pushBack(Token token);

    /// Takes the next token if it is this word or symbol.
    bool accept(std::string_view wordOrSymbol);
    /// Takes it or reports "expected `}` ...": `purpose` completes the sentence ("to close `isosurface`"). A
    /// `{` is told, too, but counts as taken where a text has fewer of them than `}`, or only a stray word
    /// stands in front of it.
    bool expect(std::string_view wordOrSymbol, std::string_view purpose = {});
    /// Skips to behind the brace that closes the block at hand; the opening brace has been read.
    void skipBlock();
    /// Skips one unknown statement: up to its block's end, or to before the next word or closing brace.
    void skipStatement();

    /// Closes a block whose `}` seems to be missing in front of the next token: that begins a line, of a text
    /// with fewer `}` than `{`. The next token is a `}` then, and whoever reads the block has to tell it, but
    /// for blocks around one that was closed at the same place. `none` where nothing is done.
    enum class MissingBrace : std::uint8_t { none, first, around };
    MissingBrace supplyBrace();
    /// Adds the brace behind the token taken last; nothing in a text other than the scene.
    std::vector<QuickFix> braceFix(std::string_view brace = "}") const;

    /// Runs the directive of a word, `declare`, that stands without a `#` and was taken last.
    void runDirective(const Token& word);

    /// Diagnostics, symbols and options of this parse; shared with the parsers.
    ParseContext& context() { return context_; }
    /// Range of the token taken last.
    const SourceRange& lastRange() const;
    /// Whether reading has been cut off (budget, depth).
    bool cutOff() const;

    /// Takes `steps` from the step budget, for work and memory that few tokens ask for. False, with
    /// everything behind cut off, when it is spent.
    bool charge(std::size_t steps, const SourceRange& range);
    // A text that spends the whole budget on one of these takes 0.5 to 2 GB.
    static constexpr std::size_t stepsPerElement = 64;   ///< of arrays
    static constexpr std::size_t charactersPerStep = 4;  ///< of strings
    static constexpr std::size_t stepsPerNumber = 16;    ///< numbers and vectors that shapes and splines keep
    static constexpr std::size_t stepsPerItem = 256;     ///< lights, fogs, textures of maps, and the like

    /// Ends the reading with an error, once: whatever asks for more gets the end of the text.
    void cut(std::string id, const SourceRange& range, std::string message, std::string hint = {});

    /// Macro calls and includes may be this deep.
    static constexpr std::size_t macroDepthLimit = 200;
    static constexpr std::size_t includeDepthLimit = 32;

  private:
    friend class DirectiveReader;
    friend class DefinitionReader;
    friend class MacroCaller;
    friend class ValueReader;
    friend class DirectiveScope;

    Token fetch();
    /// The next token of the innermost text itself: no directives, no macros.
    Token raw();
    /// Whether the directive at hand ends in front of `token`, a `#` or a macro's name that has been read.
    bool endsValue(const Token& token) const;
    /// An end token in front of `token`, which is read again later.
    Token stopAt(Token token);
    void leaveFrame();
    bool supplyOpening(Diagnostic& mistake);
    /// How many `}` the text lacks, but for those that have been supplied; below 0 it lacks `{`.
    std::ptrdiff_t& missingBraces(std::uint32_t file);
    void reportUnclosedBlocks();
    Token endToken() const;

    ParseContext& context_;
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace isoscope
