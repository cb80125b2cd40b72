// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/directives/text_files.h"

#include <cmath>

#include "core/language/tokens/lexer.h"
#include "core/text/number_format.h"

namespace isoscope {

namespace {

std::string printed(double value) {
    constexpr int digits = 6;
    return std::isnan(value) && std::signbit(value) ? "-nan" : generalNumber(value, digits);
}

/// A number with its sign.
std::optional<double> readNumber(Lexer& lexer, Token token) {
    double sign = 1;
    while (token.is("-") || token.is("+")) {
        if (token.is("-")) sign = -sign;
        token = lexer.next();
    }
    if (token.is("true") || token.is("yes") || token.is("on")) return sign;
    if (token.is("false") || token.is("no") || token.is("off")) return 0;
    if (token.kind != TokenKind::number) return std::nullopt;
    return sign * token.number;
}

std::optional<Value> readVector(Lexer& lexer) {
    VectorValue vector;
    vector.count = 0;
    while (vector.count < 5) {
        const std::optional<double> number = readNumber(lexer, lexer.next());
        if (!number) return std::nullopt;
        vector.components[static_cast<std::size_t>(vector.count++)] = *number;
        const Token behind = lexer.next();
        if (behind.is(">")) return vector.count >= 2 ? std::optional<Value>(Value{vector}) : std::nullopt;
        if (!behind.is(",")) return std::nullopt;
    }
    return std::nullopt;
}

std::optional<Value> readValue(Lexer& lexer) {
    const Token token = lexer.next();
    if (token.is("<")) return readVector(lexer);
    if (token.kind == TokenKind::string) {
        std::optional<std::uint32_t> badEscape;
        return Value{decodeString(token.text, badEscape)};
    }
    const std::optional<double> number = readNumber(lexer, token);
    return number ? std::optional<Value>(Value{NumberValue{*number}}) : std::nullopt;
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

void TextFiles::openToRead(const std::string& handle, std::string content) {
    open_[handle] = Open{false, {}, std::move(content), 0};
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
    result.value = readValue(lexer);
    if (!result.value) {
        result.atEnd = true;
        return result;
    }
    std::uint32_t behind = lexer.offset();
    Token next = lexer.next();
    if (next.is(",")) {
        behind = lexer.offset();
        next = lexer.next();
    }
    open.at = behind;
    result.atEnd = next.kind == TokenKind::end;
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
