// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/scene_draft.h"

namespace isoscope {

void reportLeftOut(ParseContext& context, const SourceRange& range, const std::string& sentence) {
    context.report({Severity::leftOut, "left-out", range, sentence, {}, {}});
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
