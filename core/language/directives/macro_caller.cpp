// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/directives/macro_caller.h"

#include "core/language/expressions/expression_parser.h"
#include "core/language/expressions/value_reader.h"
#include "core/language/tokens/nesting_guard.h"
#include "core/language/tokens/token_stream_state.h"

namespace isoscope {

namespace {

bool endsArgument(const Token& token) { return token.is(",") || token.is(")"); }

std::string signature(const MacroValue& macro) {
    std::string names;
    for (const std::string& name : macro.parameterNames) names += (names.empty() ? "" : ", ") + name;
    return "`" + macro.name + "(" + names + ")`";
}

}  // namespace

std::shared_ptr<const MacroValue> MacroCaller::find(const SymbolTable& symbols, std::string_view name) {
    const Value* value = symbols.find(name);
    const auto* macro = value ? std::get_if<std::shared_ptr<const MacroValue>>(&value->data) : nullptr;
    return macro ? *macro : nullptr;
}

void MacroCaller::call(const Token& name, const MacroValue& macro) {
    const NestingGuard guard(tokens_);
    if (!guard.ok()) return;
    TokenStream::State& state = *tokens_.state_;
    std::vector<Argument> arguments;
    SourceRange site = name.range;
    {
        DirectiveScope scope(tokens_);
        const bool understood = readArguments(name, macro, arguments);
        scope.settle();
        if (!understood || tokens_.cutOff()) return;
        site.end = tokens_.lastRange().end;
    }
    if (state.macroDepth >= TokenStream::macroDepthLimit) {
        tokens_.cut("too-deep", site,
                    "Reading stops here: macros call each other more than " +
                        std::to_string(TokenStream::macroDepthLimit) + " deep, and `" + macro.name +
                        "` once more.",
                    "a macro that calls itself needs an `#if` that ends it");
        return;
    }
    tokens_.context().symbols.pushScope();
    bind(macro, arguments);
    tokens_.context().enterCall(site, macro.body);
    const std::string_view text = tokens_.context().sources[macro.body.file].text();
    state.frames.push_back({Lexer(text, macro.body.file, macro.body.begin, macro.body.end), true, site, {}});
    ++state.macroDepth;
}

bool MacroCaller::readArguments(const Token& name, const MacroValue& macro,
                                std::vector<Argument>& arguments) {
    // Most are there: what to say of the others need not be made up for each call.
    if (!tokens_.accept("(") && !tokens_.expect("(", "and the arguments of the macro " + signature(macro)))
        return false;
    const std::size_t wanted = macro.parameterNames.size();
    while (arguments.size() < wanted && !tokens_.cutOff()) {
        // POV-Ray forgives missing commas.
        if (!arguments.empty()) tokens_.accept(",");
        // Nothing may have been looked at ahead, or a name would be taken for a call.
        Argument argument;
        if (!readReference(argument)) {
            if (tokens_.peek().is(")") || tokens_.peek().kind == TokenKind::end) break;
            argument = readArgument();
            if (std::holds_alternative<std::monostate>(argument.value.data)) {
                while (!tokens_.peek().is(")") && tokens_.peek().kind != TokenKind::end) tokens_.next();
                tokens_.accept(")");
                return false;
            }
        }
        arguments.push_back(std::move(argument));
    }
    const Token& behind = tokens_.peek();
    if (arguments.size() < wanted && (behind.is(")") || behind.kind == TokenKind::end)) {
        tokens_.context().error("argument-count", name.range,
                                "The macro " + signature(macro) + " takes " + std::to_string(wanted) +
                                    " arguments; " + std::to_string(wanted - arguments.size()) +
                                    (wanted - arguments.size() == 1 ? " is" : " are") + " missing.");
        tokens_.accept(")");
        return false;
    }
    // POV-Ray takes a comma behind the last argument, too.
    const SourceRange comma = behind.range;
    if (tokens_.accept(",") && (wanted == 0 || !tokens_.peek().is(")"))) {
        tokens_.context().error("argument-count", comma,
                                "The macro " + signature(macro) + " takes " + std::to_string(wanted) +
                                    (wanted == 1 ? " argument" : " arguments") + "; expected `)` here.");
        for (int depth = 1; depth > 0 && tokens_.peek().kind != TokenKind::end;) {
            const Token token = tokens_.next();
            depth += token.is("(") - token.is(")");
        }
        return false;
    }
    if (tokens_.accept(")")) return true;
    const std::string purpose = "to close the arguments of the macro " + signature(macro);
    const TokenStream::State& state = *tokens_.state_;
    if (state.frames.size() - 1 == state.floor) return tokens_.expect(")", purpose);
    // What was found is a macro, which has been called to look at it.
    tokens_.context().error("expected-token", state.frames[state.floor + 1].callSite,
                            "Expected `)` " + purpose + " before this call.");
    return false;
}

bool MacroCaller::readReference(Argument& argument) {
    TokenStream::State& state = *tokens_.state_;
    if (!state.ahead.empty()) {
        DirectiveScope look(tokens_);
        look.settle();
    }
    // References stand in the text of the call itself.
    if (state.frames.size() - 1 != state.floor) return false;
    Lexer& lexer = state.frames.back().lexer;
    const std::uint32_t begin = lexer.offset();
    const Token name = lexer.next();
    SymbolTable& symbols = tokens_.context().symbols;
    Value* value = name.kind == TokenKind::word ? symbols.find(name.text) : nullptr;
    if (value && !std::holds_alternative<std::shared_ptr<const MacroValue>>(value->data)) {
        std::uint32_t behind = lexer.offset();
        if (endsArgument(lexer.next())) {
            lexer.seek(behind);
            argument.reference = std::string(name.text);
            return true;
        }
        lexer.seek(behind);
        const auto* array = std::get_if<std::shared_ptr<ArrayValue>>(&value->data);
        if (array && Lexer(lexer).next().is("[")) {
            if (const std::optional<ElementPlace> place = ExpressionParser(tokens_).parseElementPlace(*array))
                if (endsArgument(tokens_.peek())) {
                    argument.array = place->array;
                    argument.element = place->element;
                    return true;
                }
            DirectiveScope look(tokens_);
            look.settle();
        }
    }
    state.frames.back().lexer.seek(begin);
    return false;
}

MacroCaller::Argument MacroCaller::readArgument() {
    Argument argument;
    if (std::optional<Value> value = ValueReader(tokens_).read()) argument.value = std::move(*value);
    return argument;
}

void MacroCaller::bind(const MacroValue& macro, std::vector<Argument>& arguments) {
    SymbolTable& symbols = tokens_.context().symbols;
    for (std::size_t k = 0; k < arguments.size(); ++k) {
        const std::string& name = macro.parameterNames[k];
        Argument& argument = arguments[k];
        if (argument.array)
            symbols.declareReference(name, argument.array, argument.element);
        else if (!argument.reference.empty())
            symbols.declareReference(name, argument.reference);
        else
            symbols.declareLocal(name, std::move(argument.value));
    }
}

}  // namespace isoscope
