// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/numbers/number_literal.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include "widgets/editor/scene_words.h"

namespace isoscope {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isWord(char c) {
    return isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
}

/// Where the number that begins at `begin` ends; `begin` itself when there is none.
std::size_t numberEnd(std::string_view line, std::size_t begin) {
    std::size_t i = begin;
    std::size_t digits = 0;
    const auto skipDigits = [&] {
        for (; i < line.size() && isDigit(line[i]); ++i) ++digits;
    };
    skipDigits();
    if (i < line.size() && line[i] == '.' && (digits > 0 || (i + 1 < line.size() && isDigit(line[i + 1])))) {
        ++i;
        skipDigits();
    }
    if (digits == 0) return begin;
    if (i < line.size() && (line[i] == 'e' || line[i] == 'E')) {
        std::size_t exponent = i + 1;
        if (exponent < line.size() && (line[exponent] == '+' || line[exponent] == '-')) ++exponent;
        if (exponent < line.size() && isDigit(line[exponent])) {
            while (exponent < line.size() && isDigit(line[exponent])) ++exponent;
            i = exponent;
        }
    }
    return i;
}

/// Words of the language that are numbers or vectors: what stands behind them is subtracted.
bool isValue(std::string_view word) {
    constexpr std::string_view values[] = {"x",           "y",
                                           "z",           "t",
                                           "u",           "v",
                                           "pi",          "tau",
                                           "true",        "false",
                                           "on",          "off",
                                           "yes",         "no",
                                           "now",         "version",
                                           "clock",       "clock_delta",
                                           "clock_on",    "initial_clock",
                                           "final_clock", "initial_frame",
                                           "final_frame", "frame_number",
                                           "image_width", "image_height"};
    return std::find(std::begin(values), std::end(values), word) != std::end(values);
}

/// Whether a minus at `minus` is a sign: no value ends before it.
bool isSign(std::string_view line, std::size_t minus) {
    std::size_t before = minus;
    while (before > 0 && (line[before - 1] == ' ' || line[before - 1] == '\t')) --before;
    if (before == 0) return true;
    const char c = line[before - 1];
    std::size_t word = before;
    while (word > 0 && isWord(line[word - 1])) --word;
    if (word < before && !isDigit(line[word]) && (word == 0 || line[word - 1] != '.')) {
        // `threshold -1`, `rgb -1`; not `Radius -1`.
        const std::string_view name = line.substr(word, before - word);
        return wordKind(QByteArray(name.data(), static_cast<qsizetype>(name.size()))) == WordKind::keyword &&
               !isValue(name);
    }
    return !isWord(c) && c != '.' && c != ')' && c != '>' && c != ']' && c != '}';
}

int decimalsOf(std::string_view literal) {
    const std::size_t e = literal.find_first_of("eE");
    const std::string_view mantissa = literal.substr(0, e);
    const std::size_t point = mantissa.find('.');
    int decimals = point == std::string_view::npos ? 0 : static_cast<int>(mantissa.size() - point - 1);
    if (e != std::string_view::npos) {
        std::string_view digits = literal.substr(e + 1);
        if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);
        int exponent = 0;
        std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
        decimals -= std::clamp(exponent, -400, 400);
    }
    return decimals;
}

}  // namespace

double NumberLiteral::step() const { return std::pow(10.0, -std::clamp(decimals, -12, 12)); }

std::optional<NumberLiteral> numberAt(std::string_view text, int position) {
    if (position < 0 || static_cast<std::size_t>(position) > text.size()) return std::nullopt;
    const std::size_t offset = static_cast<std::size_t>(position);
    std::size_t lineBegin = offset;
    while (lineBegin > 0 && text[lineBegin - 1] != '\n') --lineBegin;
    const std::string_view line = text.substr(lineBegin, text.find('\n', offset) - lineBegin);
    const std::size_t wanted = offset - lineBegin;

    for (std::size_t i = 0; i < line.size();) {
        const std::size_t end = numberEnd(line, i);
        if (end == i) {
            // A name is passed as a whole, so that its digits are not taken for a number.
            if (isWord(line[i]))
                while (i < line.size() && isWord(line[i])) ++i;
            else
                ++i;
            continue;
        }
        std::size_t begin = i;
        std::size_t minus = begin;
        while (minus > 0 && line[minus - 1] == ' ') --minus;
        if (minus > 0 && line[minus - 1] == '-' && isSign(line, minus - 1)) begin = minus - 1;
        if (wanted >= begin && wanted <= end) {
            NumberLiteral number;
            number.begin = static_cast<int>(lineBegin + begin);
            number.end = static_cast<int>(lineBegin + end);
            const auto [_, error] = std::from_chars(line.data() + i, line.data() + end, number.value);
            if (error != std::errc() || !std::isfinite(number.value)) return std::nullopt;
            if (begin != i) number.value = -number.value;
            number.decimals = decimalsOf(line.substr(i, end - i));
            return number;
        }
        if (begin > wanted) return std::nullopt;
        i = end;
    }
    return std::nullopt;
}

}  // namespace isoscope
