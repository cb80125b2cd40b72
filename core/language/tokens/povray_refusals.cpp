// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/tokens/povray_refusals.h"

#include <algorithm>

namespace isoscope {

namespace {

/// Whether text is a part of one block, without directives, that may have more behind it in its last line.
bool isMovable(std::string_view text) {
    int depth = 0;
    for (const char c : text) {
        depth += c == '{' ? 1 : c == '}' ? -1 : 0;
        if (depth < 0 || c == '#') return false;
    }
    return depth == 0 && text.find("//", text.find_last_of('\n') + 1) == std::string_view::npos;
}

}  // namespace

void warnOfRefusal(ParseContext& context, const SourceRange& range, const std::string& wants,
                   const std::string& hint, std::vector<QuickFix> fixes) {
    // Fixes are for the scene itself.
    if (range.file != 0) fixes.clear();
    context.report(
        {Severity::warning, "povray-refuses", range, "POV-Ray " + wants, hint, {}, std::move(fixes)});
}

void warnOfSuperfluous(ParseContext& context, const SourceRange& range, const std::string& wants) {
    const std::string text(context.sources.slice(range));
    warnOfRefusal(context, range, wants, "leave it out", {{"Leave `" + text + "` out", range, {}}});
}

void warnOfMissing(ParseContext& context, const SourceRange& range, const std::string& wants,
                   const std::string& added) {
    warnOfRefusal(context, range, wants, "write `" + added + "` in front of it",
                  {{"Add `" + added + "`", {range.file, range.begin, range.begin}, added + " "}});
}

void warnOfLateItem(TokenStream& tokens, const SourceRange& first, const Token& item,
                    const std::string& wants) {
    ParseContext& context = tokens.context();
    const std::uint32_t begin = item.range.begin, end = tokens.lastRange().end;
    std::vector<QuickFix> fixes;
    if (first.file == 0 && item.range.file == 0 && first.begin < begin && begin < end) {
        const std::string_view before = context.sources.slice({0, first.begin, begin});
        const std::size_t length = before.find_last_not_of(" \t\r\n") + 1;
        if (isMovable(before.substr(0, length)))
            fixes.push_back({"Move `" + std::string(item.text) + "`",
                             {0, first.begin, end},
                             std::string(context.sources.slice({0, begin, end})) +
                                 std::string(before.substr(length)) + std::string(before.substr(0, length))});
    }
    warnOfRefusal(context, item.range, wants, "move it in front of them", std::move(fixes));
}

void warnOfLastComma(TokenStream& tokens) {
    if (tokens.context().sources.slice(tokens.lastRange()) == ",")
        warnOfSuperfluous(tokens.context(), tokens.lastRange(), "takes no comma here.");
}

void warnOfLateName(ParseContext& context, const Token& name, const std::string& kind) {
    warnOfRefusal(
        context, name.range,
        "wants the name of a declared " + kind + ", `" + std::string(name.text) + "`, before other items.",
        "move it in front of them");
}

void ItemOrder::note(ParseContext& context, const Token& word, Item item) {
    const bool repeats = item == last_ && (item == Item::name || item == Item::start);
    if (repeats)
        warnOfRefusal(context, word.range, std::string("takes one beginning of a `") + block_ + "`.",
                      "leave one of the names, colours or patterns out");
    else if (item < last_ && item == Item::name)
        warnOfLateName(context, word, block_);
    else if (item < last_)
        warnOfRefusal(context, word.range,
                      "wants `" + std::string(word.text) + "` before other items of a `" + block_ + "`.",
                      "move it in front of them");
    last_ = std::max(last_, item);
}

}  // namespace isoscope
