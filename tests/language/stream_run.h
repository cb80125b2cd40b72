// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/language/expressions/expression_parser.h"
#include "core/language/tokens/words.h"

namespace isoscope::test {

/// A text whose tokens have all been read, with statements that directives may name (`sphere { ... }`)
/// skipped as opaque values.
struct StreamRun {
    std::unique_ptr<ParseContext> context;
    std::string tokens;  ///< texts of all tokens, blanks between them

    /// `line:column: severity: message` of each diagnostic, with ` < line:column` for each place it was
    /// reached from.
    std::vector<std::string> messages() const {
        std::vector<std::string> lines;
        for (const Diagnostic& diagnostic : context->diagnostics) {
            Diagnostic bare = diagnostic;
            bare.hint.clear();
            std::string line = toString(bare, context->sources);
            if (line.starts_with("scene.pov:")) line = line.substr(10);
            for (const SourceRange& site : diagnostic.reachedFrom) {
                const LineColumn at = context->sources[site.file].position(site.begin);
                line += " < " + std::to_string(at.line) + ":" + std::to_string(at.column);
            }
            lines.push_back(line);
        }
        return lines;
    }

    /// All messages in one string, `; ` between them.
    std::string said() const {
        std::string all;
        for (const std::string& line : messages()) all += (all.empty() ? "" : "; ") + line;
        return all;
    }
};

inline std::optional<Value> readOpaque(TokenStream& tokens) {
    if (!isReservedWord(tokens.peek().text)) return std::nullopt;
    const Token word = tokens.next();
    if (tokens.accept("{")) tokens.skipBlock();
    return Value{OpaqueValue{std::string(word.text)}};
}

inline StreamRun run(const std::string& text, ParseOptions options = {}) {
    StreamRun result;
    result.context = std::make_unique<ParseContext>(std::move(options));
    const std::uint32_t file = result.context->sources.add("scene.pov", text);
    TokenStream tokens(*result.context, file);
    tokens.setValueParser(readOpaque);
    while (tokens.peek().kind != TokenKind::end)
        result.tokens += (result.tokens.empty() ? "" : " ") + std::string(tokens.next().text);
    return result;
}

/// "2.5", "<1, 2, 3>", "color <...>", "\"text\"", or the kind of anything else; numbers in the shortest exact
/// form.
std::string printed(const Value& value);

/// The value of `name` after the text, printed; "nothing" when it is not declared.
inline std::string valueAfter(const std::string& text, const std::string& name = "A") {
    const StreamRun done = run(text);
    const Value* value = done.context->symbols.find(name);
    const std::string shown = value ? printed(*value) : "nothing";
    return done.said().empty() ? shown : shown + " | " + done.said();
}

inline std::string shortest(double number) {
    char buffer[40];
    for (int digits = 6; digits <= 17; ++digits) {
        std::snprintf(buffer, sizeof buffer, "%.*g", digits, number);
        if (std::strtod(buffer, nullptr) == number) break;
    }
    return buffer;
}

inline std::string printed(const Value& value) {
    if (const auto* number = std::get_if<NumberValue>(&value.data)) return shortest(number->value);
    if (const auto* text = std::get_if<std::string>(&value.data)) return '"' + *text + '"';
    const auto* vector = std::get_if<VectorValue>(&value.data);
    if (!vector) return kindOf(value);
    std::string list;
    for (int i = 0; i < vector->count; ++i)
        list += (i > 0 ? ", " : "") + shortest(vector->components[static_cast<std::size_t>(i)]);
    return (vector->color ? "color <" : "<") + list + ">";
}

}  // namespace isoscope::test
