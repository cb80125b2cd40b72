// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/scene_mutator.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

namespace isoscope::test {

namespace {

std::size_t below(std::size_t count, std::mt19937_64& random) { return count == 0 ? 0 : random() % count; }

/// Words, numbers, strings, single symbols, and blanks behind them.
std::vector<std::string> tokensOf(std::string_view text) {
    const auto isWord = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == '#';
    };
    std::vector<std::string> tokens;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at + 1;
        if (text[at] == '"')
            end = std::min(text.find('"', end), text.size() - 1) + 1;
        else if (isWord(text[at]))
            while (end < text.size() && isWord(text[end])) ++end;
        while (end < text.size() && std::isspace(static_cast<unsigned char>(text[end]))) ++end;
        tokens.emplace_back(text.substr(at, end - at));
        at = end;
    }
    return tokens;
}

constexpr std::array edges{"0 ",          "-0 ",
                           "1 ",          "-1 ",
                           "1e308 ",      "-1e308 ",
                           "1e-320 ",     "1e999 ",
                           "0.5 ",        "2147483647 ",
                           "2147483648 ", "-2147483649 ",
                           "4294967296 ", "9007199254740993 ",
                           "1e18 ",       "255 ",
                           "256 ",        "65536 ",
                           "3 "};
constexpr std::array words{"{ ",
                           "} ",
                           "( ",
                           ") ",
                           "< ",
                           "> ",
                           ", ",
                           "; ",
                           "[ ",
                           "] ",
                           "#declare A = ",
                           "#end ",
                           "#while (1) ",
                           "#if (0) ",
                           "#macro M(A) ",
                           "M(1) ",
                           "#for (I, 1, 9) ",
                           "object { ",
                           "function { ",
                           "isosurface { ",
                           "pigment { ",
                           "texture { ",
                           "union { ",
                           "rgb ",
                           "translate ",
                           "\"\" ",
                           "A ",
                           "x ",
                           "sum(i,1,3,",
                           "array[3] ",
                           "#undef A ",
                           "#local B = ",
                           "normal { "};

/// Up to sixty tokens of a text, from any place on.
std::vector<std::string> someTokensOf(std::string_view text, std::mt19937_64& random) {
    constexpr std::size_t reach = 1024, most = 60;
    std::vector<std::string> tokens = tokensOf(text.substr(below(text.size(), random), reach));
    tokens.resize(std::min(tokens.size(), 1 + below(most, random)));
    return tokens;
}

void changeOne(std::vector<std::string>& tokens, std::string_view other, std::mt19937_64& random) {
    const auto place = [&](std::size_t index) { return tokens.begin() + static_cast<std::ptrdiff_t>(index); };
    const std::size_t at = below(tokens.size(), random), second = below(tokens.size(), random);
    switch (random() % 8) {
        case 0: tokens.erase(place(at)); break;
        case 1: tokens.insert(place(at), std::string(tokens[at])); break;
        case 2: std::swap(tokens[at], tokens[second]); break;
        case 3: {
            // The next number from here on.
            const auto number = std::find_if(place(at), tokens.end(), [](const std::string& token) {
                return std::isdigit(static_cast<unsigned char>(token[0])) != 0;
            });
            if (number != tokens.end()) *number = edges[below(edges.size(), random)];
            break;
        }
        case 4: tokens.insert(place(at), words[below(words.size(), random)]); break;
        case 5: tokens[at] = words[below(words.size(), random)]; break;
        case 6: {
            const std::vector<std::string> some = someTokensOf(other, random);
            tokens.insert(place(at), some.begin(), some.end());
            break;
        }
        default: tokens.erase(place(at), place(std::min(at + 1 + below(20, random), tokens.size()))); break;
    }
}

}  // namespace

std::string changedTokens(std::string_view text, std::string_view other, std::mt19937_64& random) {
    std::vector<std::string> tokens = tokensOf(text);
    for (std::size_t left = 1 + below(8, random); left > 0 && !tokens.empty(); --left)
        changeOne(tokens, other, random);
    std::string changed;
    for (const std::string& token : tokens) changed += token;
    return changed;
}

std::string partOf(std::string_view whole, std::size_t most, bool isText, std::mt19937_64& random) {
    if (whole.size() <= most || !isText) return std::string(whole.substr(0, most));
    const std::size_t line = whole.find('\n', below(whole.size() - most, random));
    return std::string(whole.substr(line == std::string_view::npos ? 0 : line + 1, most));
}

std::string changedBytes(std::string_view bytes, std::mt19937_64& random) {
    std::string changed(bytes);
    for (std::size_t left = 1 + below(8, random); left > 0 && !changed.empty(); --left) {
        // Heads of files decide most: half the changes are made there.
        const std::size_t reach = random() % 2 ? std::min<std::size_t>(changed.size(), 64) : changed.size();
        const std::size_t at = below(reach, random), count = 1 + below(16, random);
        switch (random() % 4) {
            case 0: changed[at] = static_cast<char>(random()); break;
            case 1: changed[at] = std::array{'\0', '\x01', '\x7f', '\x80', '\xff'}[below(5, random)]; break;
            case 2: changed.erase(at, count); break;
            default: changed.insert(at, changed.substr(at, count)); break;
        }
    }
    return changed;
}

}  // namespace isoscope::test
