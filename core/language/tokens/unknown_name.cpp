// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/tokens/unknown_name.h"

#include <algorithm>
#include <map>

#include "core/function/builtins/builtin.h"
#include "core/language/directives/native_includes.h"
#include "core/language/functions/function_caller.h"
#include "core/language/functions/function_parser.h"
#include "core/language/scene_draft.h"
#include "core/language/tokens/block_words.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/language/tokens/words.h"

namespace isoscope {

namespace {

bool isNameCharacter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// The names that the program's own include files declare, with their files.
const std::map<std::string, std::string, std::less<>>& includedNames() {
    static const auto names = [] {
        std::map<std::string, std::string, std::less<>> all;
        for (const NativeInclude& include : nativeIncludes())
            for (const std::string_view directive : {"#declare ", "#macro "})
                for (std::size_t at = include.text.find(directive); at != std::string_view::npos;
                     at = include.text.find(directive, at + 1)) {
                    const std::size_t begin = at + directive.size();
                    std::size_t end = begin;
                    while (end < include.text.size() && isNameCharacter(include.text[end])) ++end;
                    all.emplace(include.text.substr(begin, end - begin), include.name);
                }
        return all;
    }();
    return names;
}

/// The names of includedNames() that a person would write.
const std::vector<std::string>& offeredNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const auto& [name, include] : includedNames())
            if (name.find("_Temp") == std::string::npos && !name.ends_with("_Inc")) all.push_back(name);
        return all;
    }();
    return names;
}

/// What `word` was probably meant to be.
Suggestion suggestionFor(std::string_view word, const std::vector<std::string>& candidates) {
    int distance = 0, includedDistance = 0;
    const std::string close = closestName(word, candidates, &distance);
    // A word of the language is at the wrong place rather than misspelt.
    const std::string included =
        isReservedWord(word) ? "" : closestName(word, offeredNames(), &includedDistance);
    if (!included.empty() && (close.empty() || includedDistance < distance))
        return {included, includeThatDeclares(included)};
    return {close, {}};
}

/// Where an `#include` is best added: behind the last one before `place`, else behind `#version`, else at the
/// beginning.
SourceRange includePlace(std::string_view text, std::uint32_t place) {
    std::size_t behind = 0;
    for (const std::string_view word : {"#version", "#include"})
        for (std::size_t line = 0; line < std::min<std::size_t>(place, text.size());) {
            std::size_t next = text.find('\n', line);
            next = next == std::string_view::npos ? text.size() : next + 1;
            if (text.substr(line).starts_with(word) && next <= place) behind = std::max(behind, next);
            line = next;
        }
    const auto at = static_cast<std::uint32_t>(behind);
    return {0, at, at};
}

/// Reports the error with the hint and the fix that follow from the suggestion. What is missing altogether
/// has no word, only an include.
void reportWith(ParseContext& context, Diagnostic diagnostic, const Token& word,
                const Suggestion& suggestion) {
    const bool replaces = word.range.file == 0 && context.sources.slice(word.range) == word.text;
    if (!suggestion.word.empty()) {
        diagnostic.hint = "did you mean `" + suggestion.word + "`" +
                          (suggestion.include.empty() ? "?" : ", of " + suggestion.include + "?");
        if (replaces)
            diagnostic.fixes.push_back({"Use `" + suggestion.word + "`", word.range, suggestion.word});
    } else if (!suggestion.include.empty()) {
        const std::string line = "#include \"" + suggestion.include + "\"";
        diagnostic.hint = "add " + line;
        if (replaces)
            diagnostic.fixes.push_back({"Add `" + line + "`",
                                        includePlace(context.sources[0].text(), diagnostic.range.begin),
                                        line + "\n"});
    }
    context.report(std::move(diagnostic));
}

/// What the suggestion for `word` at this kind of place is, by `find` the first time.
const Suggestion& remembered(ParseContext& context, std::string_view word, std::string_view place,
                             const std::function<Suggestion()>& find) {
    const std::string key = std::string(word) + '\n' + std::string(place);
    const auto known = context.suggestions.find(key);
    if (known != context.suggestions.end()) return known->second;
    ++context.suggestionsLookedFor;
    return context.suggestions.emplace(key, find()).first->second;
}

bool isOperator(const Token& token) {
    return token.kind == TokenKind::symbol && (token.text.find_first_of("+-*/,(<=&|?:.!^[") == 0);
}

/// Whether `word` belongs to the value in front of it rather than begins an item.
bool continuesValue(const ParseContext& context, std::string_view word) {
    return isWordFor(WordUse::constant | WordUse::color | WordUse::expressionFunction, word) ||
           context.symbols.find(word) || findBuiltin(word);
}

/// What may begin an item of the block or, where nothing of it is like `word`, of any block.
std::vector<std::string> itemWords(const ParseContext& context, std::string_view word,
                                   std::string_view block) {
    std::vector<std::string> words = wordsOfBlock(block);
    for (const std::string& name : context.symbols.names()) words.push_back(name);
    return closestName(word, words).empty() ? wordsOfBlock("?") : words;
}

/// Whether the next word, which is unknown or reserved by the language, begins an item: it is much like one
/// that does, or has a block.
bool beginsItem(TokenStream& tokens, std::string_view block) {
    const Token word = tokens.peek();
    if (isReservedWord(word.text)) return true;
    ParseContext& context = tokens.context();
    const Suggestion& meant = remembered(context, word.text, block, [&] {
        return suggestionFor(word.text, itemWords(context, word.text, block));
    });
    if (!meant.word.empty()) return true;
    tokens.next();
    const bool hasBlock = tokens.peek().is("{");
    tokens.pushBack(word);
    return hasBlock;
}

}  // namespace

void reportUnknownName(ParseContext& context, const Token& word) {
    const std::string name(word.text.substr(0, 60));
    if (isReservedWord(word.text)) {
        context.error("unexpected-word", word.range, "`" + name + "` cannot stand here; expected a value.");
        return;
    }
    if (context.failedNames.contains(word.text)) return;
    if (word.is("dictionary")) {
        context.error("not-read", word.range, "Dictionaries, which came with POV-Ray 3.8, are not read.",
                      "use an array, or a name for each entry");
        return;
    }
    Diagnostic unknown{
        Severity::error, "unknown-name", word.range, "`" + name + "` is not declared.", {}, {}};
    if (!context.keeps(unknown)) return context.report(std::move(unknown));
    const Suggestion& suggestion = remembered(context, word.text, "value", [&]() -> Suggestion {
        if (std::string include = includeThatDeclares(word.text); !include.empty()) return {{}, include};
        std::vector<std::string> candidates = context.symbols.names();
        for (const std::string& function : FunctionCaller::names()) candidates.push_back(function);
        for (const Word& entry : words())
            if (entry.known() && entry.is(WordUse::constant | WordUse::color))
                candidates.emplace_back(entry.text);
        if (context.builtinsKnown)
            for (const Builtin& builtin : builtins()) candidates.push_back(builtin.name);
        return suggestionFor(word.text, candidates);
    });
    reportWith(context, std::move(unknown), word, suggestion);
}

void reportUnknownWord(ParseContext& context, const std::string& id, const Token& word, std::string message,
                       std::string_view place, const std::function<std::vector<std::string>()>& candidates,
                       std::optional<SourceRange> about) {
    // Its declaration held a mistake, which has been told.
    if (context.failedNames.contains(word.text)) return;
    Diagnostic unknown{Severity::error, id, about.value_or(word.range), std::move(message), {}, {}};
    if (word.kind != TokenKind::word || !context.keeps(unknown)) return context.report(std::move(unknown));
    const Suggestion& suggestion =
        remembered(context, word.text, place, [&] { return suggestionFor(word.text, candidates()); });
    reportWith(context, std::move(unknown), word, suggestion);
}

bool closeUnclosed(TokenStream& tokens, std::string_view block) {
    const Token first = tokens.peek();
    if (!isReservedWord(first.text)) return false;
    const TokenStream::MissingBrace missing = tokens.supplyBrace();
    if (missing != TokenStream::MissingBrace::first) return missing != TokenStream::MissingBrace::none;
    tokens.context().report(
        {Severity::error,
         "unclosed-block",
         first.range,
         "Expected `}` to close `" + std::string(block) + "` before `" + std::string(first.text) + "`.",
         {},
         {},
         tokens.braceFix()});
    return true;
}

/// skipUnknownItem() behind the first token of the item.
static void skipRestOfItem(TokenStream& tokens, std::string_view block);

bool passUnknownItem(TokenStream& tokens, std::string_view block, std::string_view end) {
    const Token first = tokens.peek();
    if (first.kind == TokenKind::end || first.is("}")) return false;
    if (end == "}" && closeUnclosed(tokens, block)) return true;
    ParseContext& context = tokens.context();
    tokens.next();
    if (first.is(",") && (tokens.peek().is(end) || beginsItem(tokens, block))) {
        warnOfLastComma(tokens);
        return true;
    }
    reportUnknownWord(context, "unknown-item", first,
                      describe(first) + " is not understood in `" + std::string(block) + "`.", block,
                      [&] { return itemWords(context, first.text, block); });
    skipRestOfItem(tokens, block);
    return true;
}

void skipUnknownItem(TokenStream& tokens, std::string_view block) {
    tokens.next();
    skipRestOfItem(tokens, block);
}

void skipRestOfItem(TokenStream& tokens, std::string_view block) {
    const ParseContext& context = tokens.context();
    bool expectsValue = true;  // what comes next is more of the item, be it an unknown name
    for (int depth = 0;;) {
        const Token token = tokens.peek();
        if (token.kind == TokenKind::end || token.is("}")) return;
        if (depth <= 0 && (token.is("]") || token.is(";"))) return;
        if (token.is("{")) {
            tokens.next();
            return tokens.skipBlock();
        }
        if (token.kind == TokenKind::word && !continuesValue(context, token.text)) {
            if (!expectsValue || beginsItem(tokens, block)) return;
            expectsValue = false;
        } else {
            expectsValue = isOperator(token);
        }
        if (token.is("[") || token.is("(")) ++depth;
        if (token.is("]") || token.is(")")) --depth;
        tokens.next();
    }
}

std::string includeThatDeclares(std::string_view name) {
    const auto found = includedNames().find(name);
    if (found != includedNames().end()) return found->second;
    return findBuiltin(name) ? "functions.inc" : "";
}

bool isCallableBuiltin(const ParseContext& context, std::string_view name) {
    return context.builtinsKnown && findBuiltin(name) != nullptr;
}

FunctionValue builtinFunction(const ParseContext& context, std::string_view name) {
    return builtinFunction(*findBuiltin(name), context.noiseGenerator);
}

}  // namespace isoscope
