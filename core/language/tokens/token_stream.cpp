// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/tokens/token_stream.h"

#include <utility>

#include "core/language/directives/directive_reader.h"
#include "core/language/directives/macro_caller.h"
#include "core/language/tokens/token_stream_state.h"
#include "core/language/tokens/words.h"

namespace isoscope {

namespace {

bool opens(const Token& token) {
    return token.kind == TokenKind::symbol && (token.text == "{" || token.text == "(" || token.text == "[");
}

bool closes(const Token& token) {
    return token.kind == TokenKind::symbol && (token.text == "}" || token.text == ")" || token.text == "]");
}

std::string described(const Token& token) {
    if (token.kind == TokenKind::end) return "the text ends here";
    const std::string shown(token.text.substr(0, 40));
    return "found " + (token.kind == TokenKind::string ? "the string " + shown : "`" + shown + "`");
}

/// How many more blocks a text opens than it closes.
std::ptrdiff_t unclosedBlocks(std::string_view text, std::uint32_t file) {
    std::ptrdiff_t open = 0;
    Lexer lexer(text, file);
    for (Token token = lexer.next(); token.kind != TokenKind::end; token = lexer.next())
        open += token.is("{") - token.is("}");
    return open;
}

bool beginsLine(std::string_view text, std::uint32_t place) {
    const std::size_t before = text.substr(0, place).find_last_not_of(" \t");
    return before == std::string_view::npos || text[before] == '\n' || text[before] == '\r';
}

/// A declared name or `clock` needs nothing more; `rgb` or `texture` does.
bool isWholeValue(std::string_view word) {
    const Word* known = findWord(word);
    return !known || !known->reserved() || known->is(WordUse::constant);
}

}  // namespace

void TokenStream::State::Reach::take(const Token& token) {
    if (opens(token)) ++depth;
    if (closes(token)) --depth;
    if (!stopWhenComplete) return;
    complete = (token.kind == TokenKind::word && isWholeValue(token.text)) ||
               token.kind == TokenKind::number || token.kind == TokenKind::string || closes(token) ||
               token.is(">") || token.is(";");
}

void TokenStream::State::Reach::giveBack(const Token& token) {
    if (opens(token)) --depth;
    if (closes(token)) ++depth;
}

TokenStream::TokenStream(ParseContext& context, std::uint32_t file)
    : context_(context), state_(std::make_unique<State>(context)) {
    state_->frames.push_back({Lexer(context.sources[file].text(), file), false, {file, 0, 0}, {}});
    state_->lastRange = {file, 0, 0};
}

TokenStream::~TokenStream() = default;

void TokenStream::setValueParser(ValueParser parser) { state_->valueParser = std::move(parser); }
void TokenStream::setDefaultParser(DefaultParser parser) { state_->defaultParser = std::move(parser); }

const Token& TokenStream::peek() {
    // What was looked at before the text was cut off is no more there than what follows.
    if (state_->cutOff && !state_->ahead.empty() && state_->ahead.back().kind != TokenKind::end)
        state_->ahead.back() = endToken();
    if (state_->ahead.empty()) {
        // Running a directive may itself leave a token to be read next.
        Token token = fetch();
        state_->ahead.push_back(std::move(token));
    }
    return state_->ahead.back();
}

Token TokenStream::next() {
    peek();
    Token token = std::move(state_->ahead.back());
    state_->ahead.pop_back();
    if (token.kind == TokenKind::end) return token;
    state_->reach.take(token);
    state_->lastRange = token.range;
    return token;
}

Token TokenStream::nextName() {
    if (!state_->ahead.empty()) return next();
    Token token = raw();
    if (token.kind != TokenKind::end) {
        state_->reach.take(token);
        state_->lastRange = token.range;
    }
    return token;
}

void TokenStream::pushBack(Token token) {
    state_->reach.giveBack(token);
    state_->ahead.push_back(std::move(token));
}

bool TokenStream::accept(std::string_view wordOrSymbol) {
    if (!peek().is(wordOrSymbol)) return false;
    next();
    return true;
}

bool TokenStream::expect(std::string_view wordOrSymbol, std::string_view purpose) {
    if (accept(wordOrSymbol)) return true;
    const Token& found = peek();
    std::string message = "Expected `" + std::string(wordOrSymbol) + "`";
    if (!purpose.empty()) message += " " + std::string(purpose);
    Diagnostic mistake{
        Severity::error, "expected-token", found.range, message + ", but " + described(found) + ".", {}, {}};
    if (wordOrSymbol == "}" && found.kind == TokenKind::end) mistake.fixes = braceFix();
    if (wordOrSymbol != "{") {
        context_.report(std::move(mistake));
        return false;
    }
    const bool supplied = supplyOpening(mistake);
    context_.report(std::move(mistake));
    return supplied;
}

/// Whether the `{` that is missing here counts as read; the mistake gets its fix then. A stray word in front
/// of a brace, or in its place, is passed over.
bool TokenStream::supplyOpening(Diagnostic& mistake) {
    const Token stray = peek();
    const bool isStray =
        stray.kind == TokenKind::word && !isReservedWord(stray.text) && !context_.symbols.find(stray.text);
    if (isStray) {
        next();
        if (accept("{")) return true;
    }
    const std::pair place(stray.range.file, stray.range.begin);
    if (!state_->openings.contains(place)) {
        std::ptrdiff_t& missing = missingBraces(place.first);
        if (missing >= 0 || stray.kind == TokenKind::end) {
            if (isStray) pushBack(stray);
            return false;
        }
        ++missing;
        state_->openings.insert(place);
    }
    ++state_->reach.depth;
    if (!isStray) mistake.fixes = braceFix("{");
    return true;
}

std::vector<QuickFix> TokenStream::braceFix(std::string_view brace) const {
    const SourceRange& last = state_->lastRange;
    if (last.file != 0) return {};
    return {{"Add `" + std::string(brace) + "`", {0, last.end, last.end}, " " + std::string(brace)}};
}

std::ptrdiff_t& TokenStream::missingBraces(std::uint32_t file) {
    const auto [missing, isNew] = state_->missingBraces.try_emplace(file);
    if (isNew) missing->second = unclosedBlocks(context_.sources[file].text(), file);
    return missing->second;
}

void TokenStream::skipBlock() {
    for (int depth = 1; depth > 0;) {
        const Token token = next();
        if (token.kind == TokenKind::end) return;
        if (token.is("{")) ++depth;
        if (token.is("}")) --depth;
    }
}

void TokenStream::skipStatement() {
    next();
    for (;;) {
        const Token& token = peek();
        if (token.kind == TokenKind::word || token.kind == TokenKind::end || token.is("}")) return;
        if (next().is("{")) return skipBlock();
    }
}

TokenStream::MissingBrace TokenStream::supplyBrace() {
    const Token& token = peek();
    if (token.kind != TokenKind::word || cutOff()) return MissingBrace::none;
    const SourceRange place = {token.range.file, token.range.begin, token.range.begin};
    const bool isAround = lastRange() == place;
    if (!isAround) state_->suppliedHere = 0;
    int& granted = state_->closings[{place.file, place.begin}];
    if (state_->suppliedHere == granted) {
        std::ptrdiff_t& missing = missingBraces(place.file);
        if (missing <= 0 || !beginsLine(context_.sources[place.file].text(), place.begin))
            return MissingBrace::none;
        --missing;
        ++granted;
    }
    ++state_->suppliedHere;
    Token brace;
    brace.kind = TokenKind::symbol;
    brace.text = "}";
    brace.range = place;
    state_->ahead.push_back(std::move(brace));
    return isAround ? MissingBrace::around : MissingBrace::first;
}

const SourceRange& TokenStream::lastRange() const { return state_->lastRange; }
bool TokenStream::cutOff() const { return state_->cutOff; }

bool TokenStream::charge(std::size_t steps, const SourceRange& range) {
    State& state = *state_;
    if (context_.stopAsked()) {
        Diagnostic message = context_.stopMessage(range);
        cut(std::move(message.id), range, std::move(message.message), std::move(message.hint));
        return false;
    }
    const std::size_t budget = context_.options.stepBudget;
    if (const auto& progress = context_.options.progress) {
        progress->steps.store(state.steps + steps, std::memory_order_relaxed);
        if (range.file == 0) progress->place.store(range.begin, std::memory_order_relaxed);
    }
    if (steps <= budget && state.steps <= budget - steps) {
        state.steps += steps;
        return !state.cutOff;
    }
    state.steps = budget;
    // The loop that has run most often is the one that does not end, be it outside or inside another.
    const DirectiveBlock* busiest = nullptr;
    for (const TokenFrame& frame : state.frames)
        for (const DirectiveBlock& block : frame.blocks)
            if (block.isLoop() && (!busiest || block.rounds > busiest->rounds)) busiest = &block;
    if (busiest && busiest->rounds > 0)
        cut("loop-cut-off", busiest->range,
            "This loop was cut off after " + std::to_string(busiest->rounds) +
                " rounds, because the text asks for more than " + std::to_string(budget) + " steps.",
            "make sure that its condition becomes false");
    else
        cut("too-long", range,
            "Reading stops here: the text asks for more than " + std::to_string(budget) + " steps.");
    return false;
}

void TokenStream::cut(std::string id, const SourceRange& range, std::string message, std::string hint) {
    if (state_->cutOff) return;
    state_->cutOff = true;
    context_.error(std::move(id), range, std::move(message), std::move(hint));
    context_.complete = false;
}

Token TokenStream::endToken() const {
    const Lexer& lexer = state_->frames.back().lexer;
    Token token;
    token.range = {lexer.file(), lexer.offset(), lexer.offset()};
    return token;
}

Token TokenStream::raw() {
    TokenFrame& frame = state_->frames.back();
    Token token = frame.lexer.next();
    if (const auto mistake = frame.lexer.takeMistake()) context_.report(std::move(*mistake));
    if (state_->cutOff || !charge(1, token.range)) return endToken();
    if (token.kind == TokenKind::string) {
        std::optional<std::uint32_t> badEscape;
        token.string = decodeString(token.text, badEscape);
        if (badEscape)
            context_.warning(
                "unknown-escape",
                {token.range.file, token.range.begin + *badEscape, token.range.begin + *badEscape + 2},
                "`" + std::string(token.text.substr(*badEscape, 2)) + "` is no escape sequence.",
                "write `\\\\` for a backslash");
    }
    return token;
}

Token TokenStream::fetch() {
    State& state = *state_;
    for (;;) {
        if (state.cutOff) return endToken();
        const std::size_t top = state.frames.size() - 1;
        const bool atFloor = top == state.floor;
        Token token = raw();
        const bool isSpare = state.spareSemicolon && token.is(";");
        state.spareSemicolon = state.spareSemicolon && token.kind == TokenKind::end;
        if (isSpare) continue;
        if (token.kind == TokenKind::end) {
            if (!atFloor && !state.cutOff) {
                leaveFrame();
                continue;
            }
            if (!state.inDirective) reportUnclosedBlocks();
            return token;
        }
        if (token.is("#")) {
            if (endsValue(token)) return stopAt(token);
            DirectiveReader(*this).run(token);
        } else if (token.kind == TokenKind::word) {
            const std::shared_ptr<const MacroValue> macro = MacroCaller::find(context_.symbols, token.text);
            if (!macro) return token;
            if (endsValue(token)) return stopAt(token);
            MacroCaller(*this).call(token, *macro);
        } else {
            return token;
        }
        if (!state.ahead.empty()) {
            Token left = std::move(state.ahead.back());
            state.ahead.pop_back();
            return left;
        }
    }
}

void TokenStream::runDirective(const Token& word) {
    if (state_->ahead.empty()) DirectiveReader(*this).run(word.range, word);
}

bool TokenStream::endsValue(const Token& token) const {
    const State& state = *state_;
    const bool ownBlock = state.frames.back().blocks.size() > state.blocksBefore;
    if (!state.inDirective || state.frames.size() - 1 != state.floor || ownBlock) return false;
    if (state.reach.stopped()) return true;
    // What closes or continues a block around the directive cannot be part of it, however unfinished it is.
    if (!token.is("#")) return false;
    const Token word = Lexer(state.frames.back().lexer).next();
    return word.is("end") || word.is("else") || word.is("elseif");
}

Token TokenStream::stopAt(Token token) {
    state_->frames.back().lexer.seek(token.range.begin);
    token.kind = TokenKind::end;
    return token;
}

void TokenStream::leaveFrame() {
    reportUnclosedBlocks();
    if (state_->frames.back().isMacro) --state_->macroDepth;
    state_->frames.pop_back();
    context_.symbols.popScope();
    context_.leaveCall();
}

void TokenStream::reportUnclosedBlocks() {
    std::vector<DirectiveBlock>& blocks = state_->frames.back().blocks;
    for (const DirectiveBlock& block : blocks)
        context_.error(
            "unclosed-directive", block.range,
            "`" + std::string(context_.sources.slice(block.range)) + "` is never closed; expected `#end`.");
    blocks.clear();
}

DirectiveScope::DirectiveScope(TokenStream& tokens)
    : tokens_(tokens),
      floor_(tokens.state_->floor),
      inDirective_(tokens.state_->inDirective),
      blocksBefore_(tokens.state_->blocksBefore),
      reach_(tokens.state_->reach) {
    tokens.state_->floor = tokens.state_->frames.size() - 1;
    tokens.state_->inDirective = true;
    tokens.state_->blocksBefore = tokens.state_->frames.back().blocks.size();
    tokens.state_->reach = {};
}

DirectiveScope::~DirectiveScope() {
    TokenStream::State& state = *tokens_.state_;
    // An end was only the end of the directive.
    if (!state.ahead.empty() && state.ahead.back().kind == TokenKind::end) state.ahead.pop_back();
    state.floor = floor_;
    state.inDirective = inDirective_;
    state.blocksBefore = blocksBefore_;
    state.reach = reach_;
}

void DirectiveScope::beginValue() {
    tokens_.state_->reach = {};
    tokens_.state_->reach.stopWhenComplete = true;
}

void DirectiveScope::settle() {
    TokenStream::State& state = *tokens_.state_;
    // What was looked at may be the first of a macro that was called here: then the call is what comes next.
    std::optional<SourceRange> call;
    if (state.frames.size() - 1 > state.floor) call = state.frames[state.floor + 1].callSite;
    while (state.frames.size() - 1 > state.floor) tokens_.leaveFrame();
    Lexer& lexer = state.frames.back().lexer;
    if (!state.ahead.empty()) {
        const SourceRange& first = call ? *call : state.ahead.back().range;
        const bool inThisText = first.file == lexer.file() && first.begin <= lexer.offset();
        // Of a macro of which something was taken the rest is lost.
        const SourceRange& last = state.lastRange;
        const bool isWhole =
            !call || (last.file == call->file && last.begin >= call->begin && last.end <= call->end);
        if (inThisText && isWhole && state.ahead.back().kind != TokenKind::end) lexer.seek(first.begin);
        state.ahead.clear();
    }
    state.reach = {};
}

}  // namespace isoscope
