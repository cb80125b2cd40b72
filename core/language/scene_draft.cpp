// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/scene_draft.h"

#include <utility>

namespace isoscope {

void reportLeftOut(ParseContext& context, const SourceRange& range, const std::string& sentence) {
    context.report({Severity::leftOut, "left-out", range, sentence, {}, {}});
}

std::string notSimulatedSentence(std::string_view word) {
    static constexpr std::pair<std::string_view, std::string_view> lacks[] = {
        {"photons", ": light that glass and mirrors throw on other objects is missing"},
        {"radiosity", ": light that objects throw on each other is missing"},
        {"subsurface", ": light does not shine through the surface"},
    };
    std::string sentence = "`" + std::string(word) + "` is not simulated";
    for (const auto& [known, lack] : lacks)
        if (word == known) sentence += lack;
    return sentence + ".";
}

std::string describe(const Token& token) {
    if (token.kind == TokenKind::end) return "the end of the text";
    if (token.kind == TokenKind::string) return "a string";
    return "`" + std::string(token.text) + "`";
}

SourceRange rangeSince(const SourceRange& first, const TokenStream& tokens) {
    SourceRange range = first;
    const SourceRange& last = tokens.lastRange();
    if (last.file == range.file && last.end > range.begin) range.end = last.end;
    return range;
}

}  // namespace isoscope
