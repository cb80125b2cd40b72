// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/virtualight/token_reader.h"

#include "core/language/scene_draft.h"

namespace isoscope::virtualight {

namespace {

bool opens(const Token& token) { return token.is("(") || token.is("[") || token.is("{"); }
bool closes(const Token& token) { return token.is(")") || token.is("]") || token.is("}"); }

}  // namespace

TokenReader::TokenReader(ParseContext& context, std::uint32_t file)
    : context_(context), lexer_(context.sources[file].text(), file) {}

Token TokenReader::read() {
    if (context_.stopAsked()) {
        Diagnostic message = context_.stopMessage({lexer_.file(), lexer_.offset(), lexer_.offset()});
        cut(std::move(message.id), message.range, std::move(message.message), std::move(message.hint));
        return {TokenKind::end, {}, 0, {}, lastRange_};
    }
    Token token = lexer_.next();
    if (const auto mistake = lexer_.takeMistake()) context_.report(*mistake);
    return token;
}

const Token& TokenReader::peek(std::size_t ahead) {
    while (ahead_.size() <= ahead) {
        Token token = cut_ ? Token{TokenKind::end, {}, 0, {}, lastRange_} : read();
        ahead_.push_back(std::move(token));
    }
    return ahead_[ahead];
}

Token TokenReader::next() {
    peek();
    Token token = std::move(ahead_.front());
    ahead_.pop_front();
    if (token.kind != TokenKind::end) lastRange_ = token.range;
    const std::size_t depth = depthBehind(token);
    if (depth > open_.size())
        open_ += token.text.front();
    else
        open_.resize(depth);
    return token;
}

bool TokenReader::accept(std::string_view wordOrSymbol) {
    if (!peek().is(wordOrSymbol)) return false;
    next();
    return true;
}

bool TokenReader::expect(std::string_view wordOrSymbol, std::string_view purpose) {
    if (accept(wordOrSymbol)) return true;
    if (!cut_)
        context_.error("unexpected-token", peek().range,
                       "Expected `" + std::string(wordOrSymbol) + "` " + std::string(purpose) +
                           ", but found " + described(peek()) + ".");
    return false;
}

std::size_t TokenReader::depthBehind(const Token& token) const {
    if (opens(token)) return open_.size() + 1;
    if (!closes(token)) return open_.size();
    const char opening = token.is(")") ? '(' : token.is("]") ? '[' : '{';
    const std::size_t found = open_.rfind(opening);
    return found == std::string::npos ? open_.size() : found;
}

void TokenReader::skipTo(std::size_t depth) {
    while (open_.size() > depth && peek().kind != TokenKind::end) {
        if (depthBehind(peek()) < depth) break;
        next();
    }
    if (open_.size() > depth) open_.resize(depth);
}

void TokenReader::skipItem() {
    const std::size_t depth = open_.size();
    while (peek().kind != TokenKind::end && !closes(peek())) {
        if (!opens(next())) continue;
        return skipTo(depth);
    }
}

void TokenReader::cut(std::string id, const SourceRange& range, std::string message, std::string hint) {
    if (cut_) return;
    context_.error(std::move(id), range, std::move(message), std::move(hint));
    context_.complete = false;
    cut_ = true;
    ahead_.clear();
}

SourceRange TokenReader::rangeFrom(const SourceRange& first) const {
    SourceRange range = first;
    if (lastRange_.file == first.file && lastRange_.end > first.begin) range.end = lastRange_.end;
    return range;
}

Nesting::Nesting(TokenReader& tokens) : context_(tokens.context()) {
    if (++context_.nesting > limit)
        tokens.cut("too-deep", tokens.lastRange(),
                   "Reading stops here: brackets or operators are nested more than " + std::to_string(limit) +
                       " deep.");
}

std::string described(const Token& token) { return describe(token); }

}  // namespace isoscope::virtualight
