// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/tokens/povray_refusals.h"

#include <algorithm>

namespace isoscope {

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
