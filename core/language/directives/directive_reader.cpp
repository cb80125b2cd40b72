// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/directives/directive_reader.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/language/directives/definition_reader.h"
#include "core/language/expressions/expression_parser.h"
#include "core/language/expressions/value_reader.h"
#include "core/language/tokens/nesting_guard.h"
#include "core/language/tokens/token_stream_state.h"
#include "core/language/tokens/unknown_name.h"
#include "core/language/tokens/words.h"

namespace isoscope {

namespace {

using Kind = DirectiveBlock::Kind;

bool opensBlock(std::string_view word) {
    return word == "if" || word == "ifdef" || word == "ifndef" || word == "while" || word == "for" ||
           word == "switch" || word == "macro";
}

bool continuesBlock(std::string_view word) { return word == "else" || word == "elseif"; }
bool selects(std::string_view word) { return word == "case" || word == "range" || word == "else"; }

}  // namespace

DirectiveReader::DirectiveReader(TokenStream& tokens) : tokens_(tokens) {}

ParseContext& DirectiveReader::context() { return tokens_.context(); }
std::vector<DirectiveBlock>& DirectiveReader::blocks() { return tokens_.state_->frames.back().blocks; }

const std::vector<std::string>& DirectiveReader::words() {
    static const std::vector<std::string> words{
        "break",      "case",    "debug",  "declare", "default", "else",  "elseif",
        "end",        "error",   "fclose", "fopen",   "for",     "if",    "ifdef",
        "ifndef",     "include", "local",  "macro",   "range",   "read",  "render",
        "statistics", "switch",  "undef",  "version", "warning", "while", "write"};
    return words;
}

void DirectiveReader::run(const Token& hash) {
    Token word = tokens_.raw();
    while (word.is("#")) word = tokens_.raw();
    const bool isDirective = std::ranges::binary_search(words(), word.text);
    if (word.kind != TokenKind::word || (!isDirective && isReservedWord(word.text))) {
        context().warning("unknown-directive", hash.range,
                          "`#` is not followed by the word of a directive, so it is passed over.");
        // What stands there is read as if there were no `#`.
        if (word.kind != TokenKind::end) tokens_.state_->ahead.push_back(word);
        return;
    }
    run({hash.range.file, hash.range.begin, word.range.end}, word);
}

void DirectiveReader::run(const SourceRange& range, const Token& word) {
    const NestingGuard guard(tokens_);
    if (!guard.ok()) return;
    range_ = range;
    word_ = "`#" + std::string(word.text.substr(0, 40)) + "`";
    using Runner = void (*)(DirectiveReader&, const Token&);
    using Reader = DirectiveReader;
    static const std::map<std::string_view, Runner> runners{
        {"if", [](Reader& r, const Token&) { r.runIf(); }},
        {"ifdef", [](Reader& r, const Token&) { r.runIfdef(true); }},
        {"ifndef", [](Reader& r, const Token&) { r.runIfdef(false); }},
        {"else", [](Reader& r, const Token& w) { r.runElse(w); }},
        {"elseif", [](Reader& r, const Token& w) { r.runElse(w); }},
        {"end", [](Reader& r, const Token&) { r.runEnd(); }},
        {"while", [](Reader& r, const Token&) { r.runWhile(); }},
        {"for", [](Reader& r, const Token&) { r.runFor(); }},
        {"switch", [](Reader& r, const Token&) { r.runSwitch(); }},
        {"case", [](Reader& r, const Token&) { r.runSelection(false); }},
        {"range", [](Reader& r, const Token&) { r.runSelection(true); }},
        {"break", [](Reader& r, const Token&) { r.runBreak(); }},
        {"version", [](Reader& r, const Token&) { r.runVersion(); }},
        {"include", [](Reader& r, const Token&) { r.runInclude(); }},
        {"default", [](Reader& r, const Token&) { r.runDefault(); }},
        {"debug", [](Reader& r, const Token&) { r.runMessage(Severity::note); }},
        {"statistics", [](Reader& r, const Token&) { r.runMessage(Severity::note); }},
        {"render", [](Reader& r, const Token&) { r.runMessage(Severity::note); }},
        {"warning", [](Reader& r, const Token&) { r.runMessage(Severity::warning); }},
        {"error", [](Reader& r, const Token&) { r.runMessage(Severity::error); }},
        {"fopen", [](Reader& r, const Token&) { r.runFileOpen(); }},
        {"fclose", [](Reader& r, const Token&) { r.runFileClose(); }},
        {"read", [](Reader& r, const Token&) { r.runFileRead(); }},
        {"write", [](Reader& r, const Token&) { r.runFileWrite(); }},
        {"declare",
         [](Reader& r, const Token&) { DefinitionReader(r.tokens_, r.range_).declare(false, *r.scope_); }},
        {"local",
         [](Reader& r, const Token&) { DefinitionReader(r.tokens_, r.range_).declare(true, *r.scope_); }},
        {"undef", [](Reader& r, const Token&) { DefinitionReader(r.tokens_, r.range_).undefine(); }},
    };
    DirectiveScope scope(tokens_);
    scope_ = &scope;
    const auto runner = runners.find(word.text);
    if (runner != runners.end())
        runner->second(*this, word);
    else if (word.text == "macro") {
        DefinitionReader definition(tokens_, range_);
        definition.macroHead();
        scope.settle();
        const Skipped end = skipTo(StopAt::end);
        if (!tokens_.cutOff()) definition.defineMacro(end.hash.range, end.word.kind != TokenKind::end);
    } else {
        runUnknown(word);
    }
}

void DirectiveReader::runUnknown(const Token& word) {
    reportUnknownWord(context(), "unknown-directive", word, word_ + " is not a directive.", "#", words,
                      range_);
}

Token DirectiveReader::rawQuiet() {
    Lexer& lexer = tokens_.state_->frames.back().lexer;
    Token token = lexer.next();
    // What is skipped need not make sense, but a string or comment without end hides the text behind it.
    const auto mistake = lexer.takeMistake();
    if (mistake && mistake->id.starts_with("unterminated")) context().report(std::move(*mistake));
    if (!tokens_.charge(1, token.range)) return tokens_.endToken();
    return token;
}

DirectiveReader::Skipped DirectiveReader::skipTo(StopAt stop) {
    for (int depth = 0;;) {
        Token hash = rawQuiet();
        if (hash.kind == TokenKind::end) return {hash, hash};
        if (!hash.is("#")) continue;
        Token word = rawQuiet();
        if (word.kind == TokenKind::end) return {word, word};
        if (opensBlock(word.text))
            ++depth;
        else if (depth > 0 && word.text == "end")
            --depth;
        else if (depth == 0 && (word.text == "end" || (stop == StopAt::branch && continuesBlock(word.text)) ||
                                (stop == StopAt::selection && selects(word.text))))
            return {hash, word};
    }
}

void DirectiveReader::skipToEnd(const SourceRange& range) {
    if (skipTo(StopAt::end).word.kind != TokenKind::end || tokens_.cutOff()) return;
    context().error(
        "unclosed-directive", range,
        "`" + std::string(context().sources.slice(range)) + "` is never closed; expected `#end`.");
}

double DirectiveReader::condition() {
    hasWholeCondition_ = tokens_.expect("(", "after " + word_);
    if (!hasWholeCondition_) {
        // The float that stands there instead is taken for what was meant.
        scope_->beginValue();
        const double bare =
            ExpressionParser(tokens_).atExpression() ? ExpressionParser(tokens_).parseFloat() : 0;
        scope_->settle();
        return bare;
    }
    const double value = ExpressionParser(tokens_).parseCondition();
    hasWholeCondition_ = tokens_.expect(")", "to close the condition of " + word_);
    scope_->settle();
    return value;
}

void DirectiveReader::runIf() { choose(truth()); }

void DirectiveReader::runIfdef(bool wanted) {
    const bool defined = ExpressionParser(tokens_).parseDefined(word_);
    scope_->settle();
    choose(defined == wanted);
}

void DirectiveReader::choose(bool truth) {
    const SourceRange opening = range_;
    while (!truth) {
        const Skipped at = skipTo(StopAt::branch);
        if (at.word.kind == TokenKind::end) {
            if (tokens_.cutOff()) return;
            context().error(
                "unclosed-directive", opening,
                "`" + std::string(context().sources.slice(opening)) + "` is never closed; expected `#end`.");
            return;
        }
        if (at.word.text == "end") return;
        if (at.word.text == "else") break;
        word_ = "`#elseif`";
        truth = this->truth();
    }
    DirectiveBlock block;
    block.range = opening;
    blocks().push_back(block);
}

void DirectiveReader::runElse(const Token& word) {
    if (blocks().empty() || blocks().back().isLoop()) {
        context().error("stray-directive", range_, word_ + " stands outside any `#if`.");
        return;
    }
    const DirectiveBlock block = blocks().back();
    // In a `#switch`, a case that does not end in `#break` falls through, into the `#else` too.
    if (block.kind == Kind::switchCase && word.text == "else") return;
    blocks().pop_back();
    skipToEnd(block.range);
}

void DirectiveReader::runEnd() {
    if (blocks().empty()) {
        context().error("stray-directive", range_,
                        "`#end` closes nothing: no `#if`, loop, `#switch` or `#macro` is open.");
        return;
    }
    if (blocks().back().kind == Kind::whileLoop)
        repeatWhile();
    else if (blocks().back().kind == Kind::forLoop)
        repeatFor();
    else
        blocks().pop_back();
}

void DirectiveReader::runWhile() {
    DirectiveBlock block;
    block.kind = Kind::whileLoop;
    block.range = range_;
    block.again = tokens_.state_->frames.back().lexer.offset();
    if (!truth()) return skipToEnd(block.range);
    // What is left of a condition may never become false.
    if (!hasWholeCondition_) block.kind = Kind::conditional;
    blocks().push_back(block);
}

void DirectiveReader::repeatWhile() {
    Lexer& lexer = tokens_.state_->frames.back().lexer;
    const std::uint32_t end = lexer.offset();
    countRound();
    range_ = blocks().back().range;
    word_ = "`#while`";
    lexer.seek(blocks().back().again);
    // An `#end` inside the condition takes the loop's block away, or leaves one of its own.
    const std::size_t depth = blocks().size();
    if (truth() || blocks().size() < depth) return;
    tokens_.state_->frames.back().lexer.seek(end);
    blocks().resize(depth - 1);
}

void DirectiveReader::countRound() {
    // A round costs more than the tokens in it; and one that asks for little and never ends need not last.
    constexpr std::size_t stepsPerRound = 40;
    ++blocks().back().rounds;
    tokens_.charge(stepsPerRound, range_);
}

void DirectiveReader::runFor() {
    DirectiveBlock block;
    block.kind = Kind::forLoop;
    block.range = range_;
    tokens_.expect("(", "after `#for`");
    const Token name = tokens_.nextName();
    const bool named = name.kind == TokenKind::word && !isReservedWord(name.text);
    if (!named)
        context().error("bad-name", name.range, "Expected the name of the loop's variable after `#for (`.");
    block.variable = std::string(name.text);
    ExpressionParser expressions(tokens_);
    tokens_.accept(",");  // POV-Ray forgives missing commas
    const double first = expressions.parseFloat();
    tokens_.accept(",");
    block.last = expressions.parseFloat();
    if (tokens_.accept(",") || !tokens_.peek().is(")")) block.step = expressions.parseFloat();
    tokens_.expect(")", "to close the head of `#for`");
    scope_->settle();
    if (block.step == 0)
        context().error("endless-loop", range_, "The step of this `#for` is 0, so it would never end.");
    if (!named || block.step == 0) return skipToEnd(block.range);
    // The variable is there even where the loop has no round.
    context().symbols.declareLocal(block.variable, {NumberValue{first}});
    if (!forGoesOn(block, first)) return skipToEnd(block.range);
    block.again = tokens_.state_->frames.back().lexer.offset();
    blocks().push_back(block);
}

bool DirectiveReader::forGoesOn(const DirectiveBlock& block, double value) const {
    // The tolerance makes 0, 0.1, ... reach 1 in spite of rounding.
    constexpr double tolerance = 1e-10;
    return block.step > 0 ? value <= block.last + tolerance : value >= block.last - tolerance;
}

void DirectiveReader::repeatFor() {
    countRound();
    DirectiveBlock& block = blocks().back();
    const Value* variable = context().symbols.find(block.variable);
    const auto* number = variable ? std::get_if<NumberValue>(&variable->data) : nullptr;
    if (!number) {
        context().error(
            "lost-variable", block.range,
            "The variable `" + block.variable + "` of this `#for` is no float any more, so the loop ends.");
        blocks().pop_back();
        return;
    }
    const double value = number->value + block.step;
    context().symbols.declare(block.variable, {NumberValue{value}});
    if (forGoesOn(block, value))
        tokens_.state_->frames.back().lexer.seek(block.again);
    else
        blocks().pop_back();
}

void DirectiveReader::runSwitch() { selectCase(condition()); }

void DirectiveReader::selectCase(double selector) {
    const SourceRange opening = range_;
    for (;;) {
        const Skipped at = skipTo(StopAt::selection);
        if (at.word.kind == TokenKind::end) {
            if (!tokens_.cutOff())
                context().error("unclosed-directive", opening, "`#switch` is never closed; expected `#end`.");
            return;
        }
        if (at.word.text == "end") return;
        word_ = "`#" + std::string(at.word.text) + "`";
        if (at.word.text != "else" && !matches(selector, at.word.text == "range")) continue;
        DirectiveBlock block;
        block.kind = Kind::switchCase;
        block.range = opening;
        blocks().push_back(block);
        return;
    }
}

bool DirectiveReader::matches(double selector, bool range) {
    constexpr double tolerance = 1e-10;
    if (!range) return std::abs(condition() - selector) < tolerance;
    tokens_.expect("(", "after `#range`");
    ExpressionParser expressions(tokens_);
    const double low = expressions.parseFloat();
    tokens_.accept(",");
    const double high = expressions.parseFloat();
    tokens_.expect(")", "to close `#range`");
    scope_->settle();
    return selector >= low - tolerance && selector <= high + tolerance;
}

void DirectiveReader::runSelection(bool range) {
    const bool inSwitch = !blocks().empty() && blocks().back().kind == Kind::switchCase;
    if (!inSwitch) context().error("stray-directive", range_, word_ + " stands outside any `#switch`.");
    // Reached from the case above it, which had no `#break`: the condition no longer matters.
    matches(0, range);
}

void DirectiveReader::runBreak() {
    std::vector<DirectiveBlock>& open = blocks();
    const auto broken = std::find_if(open.rbegin(), open.rend(), [](const DirectiveBlock& block) {
        return block.kind != Kind::conditional;
    });
    if (broken == open.rend()) {
        context().error("stray-directive", range_, "`#break` stands outside any loop or `#switch`.");
        return;
    }
    const SourceRange opening = broken->range;
    for (auto left = broken - open.rbegin() + 1; left > 0; --left) {
        open.pop_back();
        skipToEnd(opening);
    }
}

}  // namespace isoscope
