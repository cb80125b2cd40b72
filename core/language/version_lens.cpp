// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/version_lens.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/language/tokens/lexer.h"
#include "core/language/tokens/words.h"

namespace isoscope {

namespace {

std::string shown(int version) {
    std::string text = std::to_string(version / 100) + "." + std::to_string(version / 10 % 10);
    return version % 10 == 0 ? text : text + std::to_string(version % 10);
}

template <class... Words>
bool mentions(const SourceText& source, Words... words) {
    const std::string_view text = source.text();
    if (((text.find(words) == std::string_view::npos) && ...)) return false;
    Lexer lexer(text, 0);
    for (Token token = lexer.next(); token.kind != TokenKind::end; token = lexer.next())
        if ((token.is(words) || ...)) return true;
    return false;
}

bool mentions(const SourceLibrary& sources, std::string_view word) {
    for (std::uint32_t file = 0; file < sources.size(); ++file)
        if (mentions(sources[file], word)) return true;
    return false;
}

/// The words of the user's text, directives with their hash, in its order.
template <class Visit>
void forEachWord(const SourceText& source, Visit visit) {
    Lexer lexer(source.text(), 0);
    SourceRange hash;
    bool behindHash = false;
    for (Token token = lexer.next(); token.kind != TokenKind::end; token = lexer.next()) {
        const bool directive = std::exchange(behindHash, false);
        if (token.is("#")) {
            behindHash = true;
            hash = token.range;
        } else if (token.kind == TokenKind::word) {
            if (directive)
                visit("#" + std::string(token.text), SourceRange{0, hash.begin, token.range.end});
            else
                visit(std::string(token.text), token.range);
        }
    }
}

std::string rulesOf(int version, const ParseResult& result) {
    if (version > Word::ourVersion)
        return "POV-Ray 3.7 refuses texts for version " + shown(version) +
               "; here they are read by the rules of 3.7.";
    std::string rules;
    if (!mentions(*result.sources, "assumed_gamma"))
        rules += " without `assumed_gamma` the picture is darker than in 3.7;";
    const std::vector<SceneObject>& objects = result.scene->objects;
    if (mentions((*result.sources)[0], "filter", "rgbf", "rgbft") &&
        std::any_of(objects.begin(), objects.end(), [](const SceneObject& one) { return one.transparent; }))
        rules += " objects with `filter` show more of their own colour than in 3.7;";
    if (hasOldNoise(result)) rules += " noise looks as with `noise_generator 1`;";
    if (rules.empty()) return {};
    rules.back() = '.';
    return "For version " + shown(version) + ":" + rules;
}

void note(ParseResult& result, const SourceRange& range, std::string message) {
    // Behind the limit that reading keeps to, notes are no loss.
    if (result.diagnostics.size() < result.options.diagnosticLimit)
        result.diagnostics.push_back({Severity::note, "version", range, std::move(message), {}, {}});
}

}  // namespace

bool hasOldNoise(const ParseResult& result) {
    return result.scene->languageVersion < 350 && !mentions(*result.sources, "noise_generator");
}

void addVersionNotes(ParseResult& result) {
    const int version = result.scene->languageVersion;
    if (version == Word::ourVersion || result.sources->size() == 0) return;
    bool stated = false;
    std::set<std::string_view> told;
    forEachWord((*result.sources)[0], [&](const std::string& word, const SourceRange& range) {
        if (word == "#version" && !std::exchange(stated, true)) {
            if (std::string rules = rulesOf(version, result); !rules.empty())
                note(result, range, std::move(rules));
            return;
        }
        const bool directive = word.front() == '#';
        const Word* entry = findWord(std::string_view(word).substr(directive ? 1 : 0));
        const bool newer = stated && entry && entry->known() && entry->since > version &&
                           entry->is(directive ? WordUse::directive : WordUse::keyword);
        if (!newer || !told.insert(entry->text).second) return;
        note(result, range,
             "`" + word + "` came with POV-Ray " + shown(entry->since) + "; the text asks for version " +
                 shown(version) + ".");
    });
}

}  // namespace isoscope
