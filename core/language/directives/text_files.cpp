// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/directives/text_files.h"

#include <algorithm>
#include <cmath>

#include "core/language/tokens/lexer.h"
#include "core/text/number_format.h"

namespace isoscope {

namespace {

std::string printed(double value) {
    constexpr int digits = 6;
    return std::isnan(value) && std::signbit(value) ? "-nan" : generalNumber(value, digits);
}

/// A number with its sign, if it has one.
std::optional<double> readNumber(Lexer& lexer, Token token) {
    const double sign = token.is("-") ? -1 : 1;
    if (token.is("-") || token.is("+")) token = lexer.next();
    if (token.kind != TokenKind::number) return std::nullopt;
    return sign * token.number;
}

/// Two to five numbers up to the closing `>`, with commas behind them or without.
std::optional<Value> readVector(Lexer& lexer) {
    VectorValue vector;
    vector.count = 0;
    Token token = lexer.next();
    while (!token.is(">") && vector.count < 5) {
        const std::optional<double> number = readNumber(lexer, token);
        if (!number) return std::nullopt;
        vector.components[static_cast<std::size_t>(vector.count++)] = *number;
        token = lexer.next();
        if (token.is(",")) token = lexer.next();
    }
    return token.is(">") && vector.count >= 2 ? std::optional<Value>(Value{vector}) : std::nullopt;
}

std::optional<Value> readValue(Lexer& lexer, const Token& token) {
    if (token.is("<")) return readVector(lexer);
    if (token.kind == TokenKind::string) {
        std::optional<std::uint32_t> badEscape;
        return Value{decodeString(token.text, badEscape)};
    }
    const std::optional<double> number = readNumber(lexer, token);
    return number ? std::optional<Value>(Value{NumberValue{*number}}) : std::nullopt;
}

bool beginsValue(const Token& token) {
    return token.kind == TokenKind::number || token.kind == TokenKind::string || token.is("<") ||
           token.is("-");
}

}  // namespace

const std::string* TextFiles::written(const std::string& file) const {
    const auto found = written_.find(file);
    return found == written_.end() ? nullptr : &found->second;
}

void TextFiles::openToWrite(const std::string& handle, const std::string& file, bool append) {
    std::string& content = written_[file];
    if (!append) {
        size_ -= content.size();
        content.clear();
    }
    open_[handle] = Open{true, file, {}, 0};
}

void TextFiles::openToRead(const std::string& handle, const std::string& file, std::string content) {
    open_[handle] = Open{false, file, std::move(content), 0};
}

bool TextFiles::write(const std::string& handle, std::string_view text) {
    const auto found = open_.find(handle);
    if (found == open_.end() || !found->second.writing || text.size() > sizeLimit - size_) return false;
    written_[found->second.file] += text;
    size_ += text.size();
    return true;
}

std::optional<TextFiles::Read> TextFiles::read(const std::string& handle) {
    const auto found = open_.find(handle);
    if (found == open_.end() || found->second.writing) return std::nullopt;
    Open& open = found->second;
    Lexer lexer(open.content, 0);
    lexer.seek(open.at);
    Read result;
    result.file = open.file;
    const Token first = lexer.next();
    if (first.kind != TokenKind::end) result.value = readValue(lexer, first);
    if (!result.value || lexer.takeMistake()) {
        constexpr std::uint32_t shown = 40;  // bytes
        const std::uint32_t begin = first.range.begin;
        result.wrong = open.content.substr(begin, std::min(lexer.offset() - begin, shown));
        result.value.reset();
        result.atEnd = true;
        return result;
    }
    const Token behind = lexer.next();
    if (beginsValue(behind)) result.lost = behind.text;
    result.atEnd = behind.kind == TokenKind::end;
    open.at = lexer.offset();
    return result;
}

std::optional<std::string> writtenForm(const Value& value) {
    if (const auto* number = std::get_if<NumberValue>(&value.data)) return printed(number->value);
    if (const auto* text = std::get_if<std::string>(&value.data)) return *text;
    const auto* vector = std::get_if<VectorValue>(&value.data);
    if (!vector) return std::nullopt;
    std::string form = "<";
    for (int k = 0; k < vector->count; ++k)
        form += (k > 0 ? "," : "") + printed(vector->components[static_cast<std::size_t>(k)]);
    return form + "> ";
}

}  // namespace isoscope
