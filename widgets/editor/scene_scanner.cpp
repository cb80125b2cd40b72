// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/scene_scanner.h"

#include <QByteArray>

#include "widgets/editor/scene_words.h"

namespace isoscope {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

SceneStyle styleOf(std::string_view word, Notation notation) {
    switch (wordKind(QByteArray::fromRawData(word.data(), static_cast<qsizetype>(word.size())), notation)) {
        case WordKind::directive: return SceneStyle::directive;
        case WordKind::keyword: return SceneStyle::keyword;
        case WordKind::function: return SceneStyle::function;
        case WordKind::unknown: return SceneStyle::plain;
    }
    return SceneStyle::plain;
}

}  // namespace

SceneScanner::Piece SceneScanner::piece(std::size_t end, SceneStyle style) {
    const int length = static_cast<int>(end - position_);
    position_ = end;
    return {length, style};
}

SceneScanner::Piece SceneScanner::next() {
    const char c = at(position_);
    if (c == '\n') return piece(position_ + 1, depth_ > 0 ? SceneStyle::comment : SceneStyle::plain);
    if (depth_ > 0 || (c == '/' && at(position_ + 1) == '*')) return piece(commentEnd(), SceneStyle::comment);
    if (c == '/' && at(position_ + 1) == '/')
        return piece(std::min(text_.find('\n', position_), text_.size()), SceneStyle::comment);
    if (c == '"') return piece(stringEnd(), SceneStyle::string);
    if (isDigit(c) || (c == '.' && isDigit(at(position_ + 1)))) return piece(numberEnd(), SceneStyle::number);
    if (isLetter(c)) {
        const std::size_t end = wordEnd(position_);
        return piece(end, styleOf(text_.substr(position_, end - position_), notation_));
    }
    if (c == '#') {
        // "# declare" with blanks between is a directive, too.
        std::size_t word = position_ + 1;
        while (isSpace(at(word))) ++word;
        const std::size_t end = wordEnd(word);
        const std::string name = "#" + std::string(text_.substr(word, end - word));
        if (end > word && styleOf(name, notation_) == SceneStyle::directive)
            return piece(end, SceneStyle::directive);
    }
    if (isSpace(c) || static_cast<unsigned char>(c) >= 0x80 || c == '\0')
        return piece(position_ + 1, SceneStyle::plain);
    return piece(position_ + 1, SceneStyle::symbol);
}

std::size_t SceneScanner::commentEnd() {
    std::size_t i = position_;
    while (i < text_.size() && text_[i] != '\n') {
        if (text_[i] == '/' && at(i + 1) == '*') {
            ++depth_;
            i += 2;
        } else if (text_[i] == '*' && at(i + 1) == '/') {
            i += 2;
            if (--depth_ == 0) break;
        } else {
            ++i;
        }
    }
    return i;
}

std::size_t SceneScanner::stringEnd() const {
    std::size_t i = position_ + 1;
    for (; i < text_.size() && text_[i] != '\n'; ++i) {
        if (text_[i] == '"') return i + 1;
        if (text_[i] == '\\' && i + 1 < text_.size() && text_[i + 1] != '\n') ++i;
    }
    return i;  // not closed: coloured to the end of the line
}

std::size_t SceneScanner::numberEnd() const {
    std::size_t i = position_;
    while (isDigit(at(i))) ++i;
    if (at(i) == '.') ++i;
    while (isDigit(at(i))) ++i;
    if (at(i) == 'e' || at(i) == 'E') {
        std::size_t exponent = i + 1;
        if (at(exponent) == '+' || at(exponent) == '-') ++exponent;
        if (isDigit(at(exponent))) {
            while (isDigit(at(exponent))) ++exponent;
            i = exponent;
        }
    }
    return i;
}

std::size_t SceneScanner::wordEnd(std::size_t begin) const {
    std::size_t i = begin;
    while (isLetter(at(i)) || isDigit(at(i))) ++i;
    return i;
}

}  // namespace isoscope
