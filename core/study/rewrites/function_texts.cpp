// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rewrites/function_texts.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/language/tokens/lexer.h"

namespace isoscope {

namespace {

constexpr std::size_t mostFunctions = 40;

/// A `#declare NAME = function(ARGUMENTS) { ... }`.
struct Declaration {
    std::vector<std::string> arguments{"x", "y", "z"};
    SourceRange body;
    std::uint32_t begin = 0;
};

/// Reads from behind `function`; false where it is none with a body.
bool readBody(Lexer& lexer, Declaration& found) {
    Token token = lexer.next();
    if (token.is("(")) {
        found.arguments.clear();
        for (token = lexer.next(); !token.is(")"); token = lexer.next()) {
            if (token.kind == TokenKind::end) return false;
            if (token.kind == TokenKind::word) found.arguments.emplace_back(token.text);
        }
        token = lexer.next();
    }
    if (!token.is("{")) return false;
    found.body = {0, token.range.end, token.range.end};
    for (int depth = 1; depth > 0;) {
        token = lexer.next();
        if (token.kind == TokenKind::end) return false;
        if (token.is("{")) ++depth;
        if (token.is("}")) --depth;
    }
    found.body.end = token.range.begin;
    return true;
}

/// The last declaration of each name that ends before byte `end`.
std::map<std::string, Declaration> declarations(std::string_view text, std::uint32_t end) {
    std::map<std::string, Declaration> all;
    Lexer lexer(text, 0, 0, end);
    for (Token token = lexer.next(); token.kind != TokenKind::end; token = lexer.next()) {
        if (!token.is("#")) continue;
        Declaration found;
        found.begin = token.range.begin;
        const Token directive = lexer.next();
        if (!directive.is("declare") && !directive.is("local")) continue;
        const Token name = lexer.next();
        if (name.kind != TokenKind::word || !lexer.next().is("=")) continue;
        const std::uint32_t next = lexer.offset();
        if (lexer.next().is("function") && readBody(lexer, found))
            all[std::string(name.text)] = found;
        else
            lexer.seek(next);
    }
    return all;
}

void collectCalls(const FormulaPart& part, std::set<std::string>& names) {
    if (part.kind == FormulaPart::Kind::call) names.insert(part.head);
    for (const FormulaPointer& one : part.parts) collectCalls(*one, names);
}

/// Whether the formula is nothing but a call with the arguments that it has itself.
bool passesOn(const FunctionText& outer) {
    const FormulaPart& call = *outer.formula;
    if (!outer.whole || call.kind != FormulaPart::Kind::call || call.parts.size() != outer.arguments.size())
        return false;
    for (std::size_t i = 0; i < call.parts.size(); ++i)
        if (canonicalText(*call.parts[i]) != outer.arguments[i]) return false;
    return true;
}

}  // namespace

std::vector<FunctionText> functionTexts(const ParseResult& parsed, std::size_t isosurface) {
    std::vector<FunctionText> all;
    if (!parsed.scene || isosurface >= parsed.scene->isosurfaces.size()) return all;
    const SceneIsosurface& subject = parsed.scene->isosurfaces[isosurface];
    if (subject.functionRange.file != 0 || subject.functionRange.begin >= subject.functionRange.end)
        return all;
    const std::string_view text = (*parsed.sources)[0].text();
    if (subject.range.file != 0 || subject.functionRange.end > text.size()) return all;
    const std::vector<std::string> axes{"x", "y", "z"};
    const FormulaPointer own = readFormula(text, subject.functionRange);
    if (!own) return all;
    all.push_back({own, axes, subject.range.begin, {}, true});
    const auto declared = declarations(text, subject.functionRange.begin);
    std::set<std::string> known;
    for (std::size_t i = 0; i < all.size() && all.size() < mostFunctions; ++i) {
        const FunctionText outer = all[i];
        std::set<std::string> names;
        collectCalls(*outer.formula, names);
        for (const std::string& name : names) {
            const auto found = declared.find(name);
            if (found == declared.end() || !known.insert(name).second) continue;
            const FormulaPointer formula = readFormula(text, found->second.body);
            if (!formula) continue;
            const bool whole = passesOn(outer) && found->second.arguments == axes;
            all.push_back({formula, found->second.arguments, found->second.begin, name, whole});
        }
    }
    return all;
}

std::size_t countWord(std::string_view text, std::string_view word) {
    std::size_t count = 0;
    Lexer lexer(text, 0);
    for (Token token = lexer.next(); token.kind != TokenKind::end; token = lexer.next())
        count += token.kind == TokenKind::word && token.text == word;
    return count;
}

}  // namespace isoscope
