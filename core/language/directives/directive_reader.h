// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/language/tokens/token_stream.h"

namespace isoscope {

struct DirectiveBlock;
class DirectiveScope;

/// Runs one directive of a TokenStream: conditions, loops, includes and messages here, definitions in
/// DefinitionReader. Each takes what belongs to it and leaves the stream at the token that is to be read
/// next.
class DirectiveReader {
  public:
    explicit DirectiveReader(TokenStream& tokens);

    /// `hash` is the `#`, already taken; its word follows.
    void run(const Token& hash);
    /// The same behind the directive's word, taken as well; `range` is that of both.
    void run(const SourceRange& range, const Token& word);

    /// Every word that may follow `#`, in alphabetical order.
    static const std::vector<std::string>& words();

  private:
    struct Skipped {
        Token hash;
        Token word;  ///< TokenKind::end where the text ends without one
    };
    /// What a search for the next directive of a block stops at besides its `#end`.
    enum class StopAt { end, branch, selection };
    Skipped skipTo(StopAt stop);
    /// Skips to the `#end` of the block begun at `range`, and says so when there is none.
    void skipToEnd(const SourceRange& range);
    Token rawQuiet();

    void runIf();
    void runIfdef(bool wanted);
    void runElse(const Token& word);
    void runEnd();
    void runWhile();
    void runFor();
    void runSwitch();
    void runSelection(bool range);
    void runBreak();
    void runVersion();
    void runInclude();
    void runDefault();
    void runMessage(Severity severity);
    void runFileOpen();
    /// What a file holds, written by this text or found on disk.
    std::optional<std::string> contentOf(const std::string& name, const SourceRange& range);
    void runFileClose();
    void runFileRead();
    /// One value of the file into the variable `name`, or into `element` of the array of this name, unless
    /// null. True when the file has no more, and is closed, or cannot be read.
    bool readFromFile(const Token& handle, const Token& name, Value* element);
    void runFileWrite();
    void runUnknown(const Token& word);

    /// Goes on in the chosen branch of an `#if` whose condition is `truth`.
    void choose(bool truth);
    void selectCase(double selector);
    bool matches(double selector, bool range);
    void countRound();
    void repeatWhile();
    void repeatFor();
    bool forGoesOn(const DirectiveBlock& block, double value) const;
    /// `( EXPRESSION )`, comparisons and all, or what there is of it.
    double condition();
    bool truth() { return isTrue(condition()); }
    static bool isTrue(double value) { return value >= 1e-10 || value <= -1e-10; }
    std::vector<DirectiveBlock>& blocks();

    ParseContext& context();
    TokenStream& tokens_;
    SourceRange range_;              ///< the `#` and its word
    std::string word_;               ///< "`#while`", for messages
    bool hasWholeCondition_ = true;  ///< whether the last one had its parentheses
    DirectiveScope* scope_ = nullptr;
};

}  // namespace isoscope
