// SPDX-License-Identifier: GPL-3.0-or-later
// The string functions of the scene language, and those that take strings.
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <ctime>

#include "core/language/directives/asset_file.h"
#include "core/language/expressions/expression_functions.h"
#include "core/text/number_format.h"

namespace isoscope {

namespace {

using Call = const ExpressionCall&;

/// Makes a string a value, or says that the text composes too many.
/// Far beyond any text that someone reads, and not so long that a few copies fill the memory.
constexpr std::size_t lengthLimit = 10'000'000;

Operand composed(Call call, std::string text) {
    if (text.size() > lengthLimit) {
        call.error("This string is longer than " + std::to_string(lengthLimit) + " characters.");
        return Operand::text({});
    }
    if (!call.tokens.charge(text.size() / TokenStream::charactersPerStep + 1, call.range))
        return Operand::text({});
    return Operand::text(std::move(text));
}

std::string mapped(const std::string& text, char from, char to, int shift) {
    std::string result = text;
    for (char& c : result)
        if (c >= from && c <= to) c = static_cast<char>(c + shift);
    return result;
}

/// `str`: at least `length` characters, filled with blanks, or with zeros where it is negative; `precision`
/// digits behind the point, six where it is negative. Both are limited to 300.
std::string formatted(double value, double length, double precision) {
    constexpr double limit = 300;
    const int width = static_cast<int>(std::min(std::abs(length), limit));
    const int digits = precision < 0 ? 6 : static_cast<int>(std::min(precision, limit));
    const bool finite = std::isfinite(value), negative = std::signbit(value);
    std::string text = finite ? fixedNumber(std::abs(value), digits) : std::isnan(value) ? "nan" : "inf";
    const std::size_t taken = text.size() + (negative ? 1 : 0), wanted = static_cast<std::size_t>(width);
    const std::string filling(wanted > taken ? wanted - taken : 0, length < 0 && finite ? '0' : ' ');
    const std::string sign = negative ? "-" : "";
    return length < 0 && finite ? sign + filling + text : filling + sign + text;
}

double finiteOr0(double value) { return std::isfinite(value) ? value : 0; }

/// 1 for a file that the text may read or has written itself, else 0.
Operand fileExists(Call call) {
    const ParseContext& context = call.tokens.context();
    if (!call.tokens.charge(TokenStream::stepsPerItem, call.range)) return Operand::number(0);
    const bool found = context.textFiles.written(call.string(0)) != nullptr ||
                       static_cast<bool>(findAsset(context, call.string(0), call.range));
    return Operand::number(found ? 1 : 0);
}

Operand concat(Call call) {
    std::string all;
    for (const Operand& part : call.arguments) all += part.string;
    return composed(call, std::move(all));
}

Operand str(Call call) {
    return composed(call, formatted(call.number(0), finiteOr0(call.number(1)), finiteOr0(call.number(2))));
}

Operand vstr(Call call) {
    const int count = static_cast<int>(std::clamp(finiteOr0(call.number(0)), 2.0, 5.0));
    std::string text;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        if (i > 0) text += call.string(2);
        text += formatted(call.arguments[1].vector.components[i], finiteOr0(call.number(3)),
                          finiteOr0(call.number(4)));
    }
    return composed(call, std::move(text));
}

Operand substr(Call call) {
    const std::string& text = call.string(0);
    const double first = std::trunc(call.number(1)), length = std::trunc(call.number(2));
    if (!(first >= 1 && length >= 0 && first + length - 1 <= static_cast<double>(text.size()))) {
        call.error("`substr` asks for characters outside the string, which has " +
                   std::to_string(text.size()) + ".");
        return Operand::text({});
    }
    return composed(call, text.substr(static_cast<std::size_t>(first) - 1, static_cast<std::size_t>(length)));
}

Operand chr(Call call) {
    const double code = std::trunc(call.number(0));
    if (!(code >= 0 && code <= 65535)) {
        call.error("`chr` needs the number of a character, 0 to 65535.");
        return Operand::text({});
    }
    std::string text;
    const auto c = static_cast<unsigned>(code);
    if (c < 0x80) {
        text += static_cast<char>(c);
    } else if (c < 0x800) {
        text += static_cast<char>(0xc0 | (c >> 6));
        text += static_cast<char>(0x80 | (c & 0x3f));
    } else {
        text += static_cast<char>(0xe0 | (c >> 12));
        text += static_cast<char>(0x80 | ((c >> 6) & 0x3f));
        text += static_cast<char>(0x80 | (c & 0x3f));
    }
    return Operand::text(std::move(text));
}

Operand datetime(Call call) {
    constexpr double daysTo2000 = 10957;
    const double seconds = (finiteOr0(call.number(0)) + daysTo2000) * 86400;
    const auto time = static_cast<std::time_t>(std::floor(std::clamp(seconds, -6e10, 2.5e11)));
    std::tm parts{};
    gmtime_r(&time, &parts);
    const std::string format = call.arguments.size() > 1 ? call.string(1) : "%Y-%m-%d %H:%M:%SZ";
    char buffer[512];
    const std::size_t length =
        format.empty() ? 0 : std::strftime(buffer, sizeof buffer, format.c_str(), &parts);
    return composed(call, std::string(buffer, length));
}

Operand asc(Call call) {
    return Operand::number(call.string(0).empty() ? 0 : static_cast<unsigned char>(call.string(0).front()));
}

Operand val(Call call) {
    const std::string& text = call.string(0);
    std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string::npos) return Operand::number(0);
    if (text[begin] == '+') ++begin;
    double value = 0;
    std::from_chars(text.data() + begin, text.data() + text.size(), value);
    return Operand::number(value);
}

/// The difference of the first characters that differ, as POV-Ray gives it.
Operand strcmp(Call call) {
    const std::string &a = call.string(0), &b = call.string(1);
    std::size_t i = 0;
    while (i < a.size() && i < b.size() && a[i] == b[i]) ++i;
    const auto code = [i](const std::string& s) {
        return i < s.size() ? static_cast<unsigned char>(s[i]) : 0;
    };
    return Operand::number(code(a) - code(b));
}

}  // namespace

const std::vector<ExpressionFunction>& stringFunctions() {
    static const std::vector<ExpressionFunction> table{
        {"asc", "s", asc},
        {"chr", "f", chr},
        {"concat", "ss*", concat},
        {"datetime", "fs?", datetime},
        {"file_exists", "s", fileExists},
        {"str", "fff", str},
        {"strcmp", "ss", strcmp},
        {"strlen", "s", [](Call c) { return Operand::number(static_cast<double>(c.string(0).size())); }},
        {"strlwr", "s", [](Call c) { return composed(c, mapped(c.string(0), 'A', 'Z', 32)); }},
        {"strupr", "s", [](Call c) { return composed(c, mapped(c.string(0), 'a', 'z', -32)); }},
        {"substr", "sff", substr},
        {"val", "s", val},
        {"vstr", "fwsff", vstr},
    };
    return table;
}

}  // namespace isoscope
