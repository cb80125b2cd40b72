// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/tokens/lexer.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace isoscope {

namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v'; }
bool isSymbol(char c) {
    return std::string_view("{}()<>[],;.+-*/&|=!?:^#~").find(c) != std::string_view::npos;
}
bool beginsToken(char c) { return isDigit(c) || isLetter(c) || isBlank(c) || isSymbol(c) || c == '"'; }

double valueOf(std::string_view digits) {
    double value = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (read.ec != std::errc::result_out_of_range) return value;
    // from_chars does not say whether the number is too large or too small; its writing does.
    const bool negativeExponent =
        digits.find_first_of("eE") != std::string_view::npos && digits.find('-') != std::string_view::npos;
    const std::size_t firstNonZero = digits.find_first_not_of('0');
    const bool fraction = firstNonZero < digits.size() && digits[firstNonZero] == '.';
    return negativeExponent || fraction ? 0 : std::numeric_limits<double>::infinity();
}

void appendUtf8(std::string& out, unsigned code) {
    if (code < 0x80) {
        out += static_cast<char>(code);
    } else if (code < 0x800) {
        out += static_cast<char>(0xc0 | (code >> 6));
        out += static_cast<char>(0x80 | (code & 0x3f));
    } else {
        out += static_cast<char>(0xe0 | (code >> 12));
        out += static_cast<char>(0x80 | ((code >> 6) & 0x3f));
        out += static_cast<char>(0x80 | (code & 0x3f));
    }
}

/// Whether the text is UTF-16: by its byte order mark, which an editor that took it for Latin-1 hands over as
/// two letters, or without one by every other byte at its beginning being 0, as it is where all are ASCII.
bool isWide(std::string_view text) {
    for (const char* mark : {"\xff\xfe", "\xfe\xff", "\xc3\xbf\xc3\xbe", "\xc3\xbe\xc3\xbf"})
        if (text.starts_with(mark)) return true;
    constexpr std::size_t looked = 64, shortest = 4;
    const std::size_t pairs = std::min(text.size(), looked) / 2;
    std::size_t first = 0, second = 0;
    for (std::size_t i = 0; i < pairs; ++i) {
        first += text[2 * i] == 0 && text[2 * i + 1] != 0 ? 1 : 0;
        second += text[2 * i] != 0 && text[2 * i + 1] == 0 ? 1 : 0;
    }
    return 2 * pairs >= shortest && std::max(first, second) == pairs;
}

/// The character that `\c` stands for, or '\0' when it stands for none.
char simpleEscape(char c) {
    switch (c) {
        case 'a': return '\a';
        case 'b': return '\b';
        case 'f': return '\f';
        case 'n': return '\n';
        case 'r': return '\r';
        case 't': return '\t';
        case 'v': return '\v';
        case '\\':
        case '"':
        case '\'': return c;
        default: return '\0';
    }
}

}  // namespace

Lexer::Lexer(std::string_view text, std::uint32_t file, std::uint32_t begin, std::uint32_t end)
    : text_(text),
      file_(file),
      position_(begin),
      end_(static_cast<std::uint32_t>(std::min<std::size_t>(end, text.size()))) {}

Lexer::Lexer(std::string_view text, std::uint32_t file)
    : Lexer(text, file, 0, static_cast<std::uint32_t>(text.size())) {}

Token Lexer::next() {
    if (position_ == 0 && isWide(text_)) {
        blame("utf-16", 0, 2, "This text is UTF-16, two bytes a character; scenes are read as UTF-8.",
              "save the file as UTF-8");
        position_ = end_;
    }
    skipBlank();
    if (position_ >= end_) return make(TokenKind::end, position_ = end_);
    const char c = text_[position_];
    if (isLetter(c)) return readWord();
    if (isDigit(c) || (c == '.' && isDigit(at(position_ + 1)))) return readNumber();
    if (c == '"') return readString();
    return readSymbol();
}

void Lexer::skipBlank() {
    while (position_ < end_) {
        const char c = text_[position_];
        if (isBlank(c))
            ++position_;
        else if (c == '/' && at(position_ + 1) == '/')
            skipLineComment();
        else if (c == '/' && at(position_ + 1) == '*')
            skipBlockComment();
        else if (!beginsToken(c))
            skipStrayBytes();
        else
            return;
    }
}

void Lexer::skipLineComment() {
    while (position_ < end_ && text_[position_] != '\n') ++position_;
}

void Lexer::skipBlockComment() {
    const std::uint32_t begin = position_;
    int depth = 0;
    while (position_ < end_) {
        const char c = text_[position_];
        if (c == '/' && at(position_ + 1) == '*') {
            ++depth;
            position_ += 2;
        } else if (c == '*' && at(position_ + 1) == '/') {
            position_ += 2;
            if (--depth == 0) return;
        } else {
            ++position_;
        }
    }
    position_ = end_;
    blame("unterminated-comment", begin, begin + 2, "This comment is never closed; expected `*/`.",
          "comments nest: every `/*` inside it needs a `*/` of its own");
}

void Lexer::skipStrayBytes() {
    const std::uint32_t begin = position_;
    // A byte order mark at the beginning of a file is no mistake.
    if (begin == 0 && text_.substr(0, 3) == "\xef\xbb\xbf") {
        position_ = 3;
        return;
    }
    while (position_ < end_ && !beginsToken(text_[position_])) ++position_;
    const auto c = static_cast<unsigned char>(text_[begin]);
    std::string what = "`" + std::string(1, text_[begin]) + "`";
    if (c < 0x20 || c == 0x7f) what = "A control character (code " + std::to_string(c) + ")";
    if (c >= 0x80) what = "A character outside ASCII";
    blame("stray-character", begin, position_,
          what + " has no meaning here; outside strings and comments, only " +
              "ASCII letters, digits and punctuation may stand.");
}

Token Lexer::readNumber() {
    const std::uint32_t begin = position_;
    while (isDigit(at(position_))) ++position_;
    if (at(position_) == '.') {
        ++position_;
        while (isDigit(at(position_))) ++position_;
    }
    std::uint32_t numberEnd = position_;
    if (at(position_) == 'e' || at(position_) == 'E') {
        std::uint32_t digits = position_ + 1;
        if (at(digits) == '+' || at(digits) == '-') ++digits;
        // `1e` and `1e+` are 1, as in POV-Ray.
        position_ = digits;
        while (isDigit(at(position_))) ++position_;
        if (position_ > digits) numberEnd = position_;
    } else if (at(position_) == '.' && isDigit(at(position_ + 1))) {
        while (at(position_) == '.' || isDigit(at(position_))) ++position_;
        blame(
            "malformed-number", begin, position_,
            "`" + std::string(text_.substr(begin, position_ - begin)) + "` has more than one decimal point.");
    }
    Token token = make(TokenKind::number, begin);
    token.number = valueOf(text_.substr(begin, numberEnd - begin));
    return token;
}

Token Lexer::readString() {
    const std::uint32_t begin = position_;
    std::uint32_t i = begin + 1;
    while (i < end_ && text_[i] != '"') i += text_[i] == '\\' && i + 1 < end_ ? 2 : 1;
    if (i < end_) {
        position_ = i + 1;
        return make(TokenKind::string, begin);
    }
    // Taking the string to the end of its line only lets the rest of the text be understood.
    position_ = begin + 1;
    while (position_ < end_ && text_[position_] != '\n') ++position_;
    blame("unterminated-string", begin, position_, "This string is never closed; expected `\"`.");
    return make(TokenKind::string, begin);
}

Token Lexer::readWord() {
    const std::uint32_t begin = position_;
    while (isLetter(at(position_)) || isDigit(at(position_))) ++position_;
    return make(TokenKind::word, begin);
}

Token Lexer::readSymbol() {
    const std::uint32_t begin = position_++;
    const char c = text_[begin];
    if ((c == '<' || c == '>' || c == '!') && at(position_) == '=') ++position_;
    return make(TokenKind::symbol, begin);
}

Token Lexer::make(TokenKind kind, std::uint32_t begin) const {
    Token token;
    token.kind = kind;
    token.text = text_.substr(begin, position_ - begin);
    token.range = {file_, begin, position_};
    return token;
}

void Lexer::blame(const char* id, std::uint32_t begin, std::uint32_t end, std::string message,
                  std::string hint) {
    if (mistake_) return;
    mistake_ = std::make_shared<Diagnostic>(
        Diagnostic{Severity::error, id, {file_, begin, end}, std::move(message), std::move(hint), {}});
}

std::string decodeString(std::string_view quoted, std::optional<std::uint32_t>& badEscape) {
    const std::string_view raw = rawString(quoted);
    std::string out;
    out.reserve(raw.size());
    for (std::size_t i = 0; i < raw.size(); ++i) {
        if (raw[i] != '\\' || i + 1 == raw.size()) {
            out += raw[i];
            continue;
        }
        if (const char plain = simpleEscape(raw[i + 1])) {
            out += plain;
            ++i;
            continue;
        }
        unsigned code = 0;
        const char* digits = raw.data() + i + 2;
        const bool unicode = raw[i + 1] == 'u' && i + 6 <= raw.size() &&
                             std::from_chars(digits, digits + 4, code, 16).ptr == digits + 4;
        if (unicode) {
            appendUtf8(out, code);
            i += 5;
        } else {
            if (!badEscape) badEscape = static_cast<std::uint32_t>(i + 1);
            out += raw[i];
        }
    }
    return out;
}

std::string_view rawString(std::string_view quoted) {
    if (!quoted.empty() && quoted.front() == '"') quoted.remove_prefix(1);
    if (!quoted.empty() && quoted.back() == '"') quoted.remove_suffix(1);
    return quoted;
}

}  // namespace isoscope
