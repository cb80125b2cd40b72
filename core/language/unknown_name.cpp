// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/unknown_name.h"

#include <algorithm>

#include "core/function/builtin.h"
#include "core/language/function_caller.h"
#include "core/language/function_parser.h"
#include "core/language/native_includes.h"
#include "core/language/reserved_words.h"

namespace isoscope {

namespace {

bool isNameCharacter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool declares(std::string_view text, std::string_view name) {
    for (std::string_view directive : {"#declare ", "#macro "}) {
        const std::string wanted = std::string(directive) + std::string(name);
        for (std::size_t at = text.find(wanted); at != std::string_view::npos;
             at = text.find(wanted, at + 1)) {
            const std::size_t behind = at + wanted.size();
            if (behind >= text.size() || !isNameCharacter(text[behind])) return true;
        }
    }
    return false;
}

std::string hintFor(const ParseContext& context, std::string_view name) {
    const std::string include = includeThatDeclares(name);
    if (!include.empty()) return "add #include \"" + include + "\"";
    std::vector<std::string> candidates = context.symbols.names();
    for (const std::string& function : FunctionCaller::names()) candidates.push_back(function);
    if (context.builtinsKnown)
        for (const Builtin& builtin : builtins()) candidates.push_back(builtin.name);
    std::string close = closestName(name, candidates);
    if (close.empty()) close = closestName(name, {reservedWords().begin(), reservedWords().end()});
    return close.empty() ? "" : "did you mean `" + close + "`?";
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
    context.error("unknown-name", word.range, "`" + name + "` is not declared.", hintFor(context, word.text));
}

std::string includeThatDeclares(std::string_view name) {
    for (const NativeInclude& include : nativeIncludes())
        if (declares(include.text, name)) return std::string(include.name);
    return findBuiltin(name) ? "functions.inc" : "";
}

bool isCallableBuiltin(const ParseContext& context, std::string_view name) {
    return context.builtinsKnown && findBuiltin(name) != nullptr;
}

FunctionValue builtinFunction(const ParseContext& context, std::string_view name) {
    return builtinFunction(*findBuiltin(name), context.noiseGenerator);
}

}  // namespace isoscope
