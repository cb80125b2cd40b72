// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/directives/definition_reader.h"

#include <algorithm>
#include <cmath>

#include "core/language/expressions/expression_parser.h"
#include "core/language/expressions/named_constants.h"
#include "core/language/expressions/slider_range.h"
#include "core/language/expressions/value_reader.h"
#include "core/language/tokens/token_stream_state.h"
#include "core/language/tokens/words.h"

namespace isoscope {

/// What stands on the left of `=`.
struct DefinitionReader::Target {
    Token name;
    std::optional<ElementPlace> element;
    bool isElement = false;
    std::optional<int> component;
    std::size_t scopeCount = 0;  ///< where the directive began
};

void DefinitionReader::declare(bool local, DirectiveScope& scope) {
    bool isNumeric = false;
    do {
        isNumeric = readOne(local, scope);
    } while (tokens_.peek().is(",") && (tokens_.next(), true) && !tokens_.cutOff());
    tokens_.state_->spareSemicolon = tokens_.accept(";") && isNumeric;
}

bool DefinitionReader::readOne(bool local, DirectiveScope& scope) {
    Target target;
    target.scopeCount = tokens_.context().symbols.scopeCount();
    const bool understood = readTarget(target);
    const std::string_view purpose = local ? "behind the name in `#local`" : "behind the name in `#declare`";
    if (!(understood ? tokens_.expect("=", purpose) : tokens_.accept("="))) {
        skipLine(target.name.range);
        if (understood) tokens_.context().failedNames.emplace(target.name.text);
        return false;
    }
    scope.beginValue();
    std::optional<SourceRange> literal;
    std::optional<Value> value = ValueReader(tokens_).read(&literal);
    if (!value || !understood) {
        // What is left of the statement, and the name, would only be misunderstood once more.
        if (!value) {
            skipRest();
            if (understood) tokens_.context().failedNames.emplace(target.name.text);
        }
        return false;
    }
    ExpressionParser expressions(tokens_);
    const bool needsSemicolon =
        std::holds_alternative<NumberValue>(value->data) || std::holds_alternative<VectorValue>(value->data);
    const Token& behind = tokens_.peek();
    const bool stray =
        behind.kind == TokenKind::symbol && !behind.is(";") && !behind.is(",") && !behind.is("}");
    if (needsSemicolon && stray) {
        if (!expressions.reportBareComparison())
            tokens_.expect(";", "behind the value of `" + std::string(target.name.text) + "`");
        skipRest();
    } else if (needsSemicolon && !behind.is(";") && !behind.is(","))
        tokens_.context().warning(
            "missing-semicolon", tokens_.lastRange(),
            "A `;` is missing behind the value of `" + std::string(target.name.text) + "`.",
            "POV-Ray 3.7 refuses the scene without it");
    if (auto* number = std::get_if<NumberValue>(&value->data)) {
        if (literal && mayBeSlider(local, target, *literal))
            number->parameter = sliderFor(std::string(target.name.text), number->value, *literal);
    }
    assign(target, std::move(*value), local);
    return needsSemicolon;
}

void DefinitionReader::skipRest() {
    while (tokens_.peek().kind != TokenKind::end && !tokens_.peek().is(";") && !tokens_.peek().is("}"))
        if (tokens_.next().is("{")) tokens_.skipBlock();
}

void DefinitionReader::skipLine(const SourceRange& start) {
    const SourceText& text = tokens_.context().sources[start.file];
    const auto line = text.position(start.begin).line;
    while (tokens_.peek().kind != TokenKind::end && tokens_.peek().range.file == start.file &&
           text.position(tokens_.peek().range.begin).line == line)
        if (tokens_.next().is(";")) return;
}

bool DefinitionReader::readTarget(Target& target) {
    ParseContext& context = tokens_.context();
    target.name = tokens_.nextName();
    // `#declare deprecated once "Reason" NAME = ...` of old include files: the reason is for readers.
    while (target.name.is("deprecated") || target.name.is("once") || target.name.kind == TokenKind::string)
        target.name = tokens_.nextName();
    if (target.name.kind != TokenKind::word || isReservedWord(target.name.text)) {
        const bool reserved = target.name.kind == TokenKind::word;
        context.error("bad-name", target.name.range,
                      reserved ? "`" + std::string(target.name.text) +
                                     "` is a word of the language and cannot be declared."
                               : "Expected the name that is to be declared.",
                      reserved ? "choose another name, best with a capital letter" : "");
        if (target.name.kind == TokenKind::symbol && target.name.text != "=") return false;
        if (!reserved && target.name.is("=")) tokens_.pushBack(target.name);
        return false;
    }
    // A macro's name is not looked at as a call here, so nothing may be peeked at before this point.
    if (tokens_.peek().is("[")) {
        target.isElement = true;
        const Value* value = context.symbols.find(target.name.text);
        const auto* array = value ? std::get_if<std::shared_ptr<ArrayValue>>(&value->data) : nullptr;
        if (!array) {
            context.error("no-array", target.name.range,
                          "`" + std::string(target.name.text) + "` is " +
                              (value ? kindOf(*value) : "not declared") + ", but `[` asks for an array.");
            while (!tokens_.peek().is("=") && tokens_.peek().kind != TokenKind::end) tokens_.next();
            return false;
        }
        target.element = ExpressionParser(tokens_).parseElementPlace(*array);
        if (!target.element) return false;
    }
    if (tokens_.accept(".")) {
        target.component = ExpressionParser(tokens_).parseComponentName();
        return target.component.has_value();
    }
    return true;
}

void DefinitionReader::assign(const Target& target, Value value, bool local) {
    if (target.component) return assignComponent(target, value);
    if (target.element) {
        if (auto* number = std::get_if<NumberValue>(&value.data)) {
            tokens_.context().markStructural(number->parameter);
            number->parameter = -1;
        }
        target.element->value() = std::move(value);
        return;
    }
    SymbolTable& symbols = tokens_.context().symbols;
    const std::string name(target.name.text);
    if (!local && isInLoop()) noteCounter(name);
    if (local)
        symbols.declareLocal(name, std::move(value), target.scopeCount);
    else
        symbols.declare(name, std::move(value), target.scopeCount);
    if (!local && isWordFor(WordUse::predeclared, name)) tokens_.context().replacedConstants.insert(name);
}

void DefinitionReader::assignComponent(const Target& target, const Value& value) {
    ParseContext& context = tokens_.context();
    Value* whole = target.element ? &target.element->value() : context.symbols.find(target.name.text);
    auto* vector = whole ? std::get_if<VectorValue>(&whole->data) : nullptr;
    const auto* number = std::get_if<NumberValue>(&value.data);
    if (!vector || *target.component >= vector->count) {
        context.error("no-component", target.name.range,
                      "`" + std::string(target.name.text) + "` is " +
                          (whole ? kindOf(*whole) : "not declared") + " without such a component.");
    } else if (!number) {
        context.error("expected-float", tokens_.lastRange(),
                      "A component is a float, but this is " + kindOf(value) + ".");
    } else {
        context.markStructural(number->parameter);
        vector->components[static_cast<std::size_t>(*target.component)] = number->value;
    }
}

bool DefinitionReader::mayBeSlider(bool local, const Target& target, const SourceRange& literal) const {
    return !local && !target.element && !target.component && literal.file == 0 &&
           tokens_.state_->frames.size() == 1 && !isInLoop();
}

/// A name that a loop declares anew: what it was declared as before is where it begins.
void DefinitionReader::noteCounter(const std::string& name) {
    ParseContext& context = tokens_.context();
    const Value* before = context.symbols.find(name);
    const auto* number = before ? std::get_if<NumberValue>(&before->data) : nullptr;
    if (!number || number->parameter < 0) return;
    // The name may stand for a number that another name was declared as.
    if (context.parameters[static_cast<std::size_t>(number->parameter)].name == name)
        context.counters.insert(number->parameter);
}

/// Whether a loop of the user's text goes on.
bool DefinitionReader::isInLoop() const {
    return std::ranges::any_of(tokens_.state_->frames.front().blocks,
                               [](const DirectiveBlock& block) { return block.isLoop(); });
}

int DefinitionReader::sliderFor(const std::string& name, double value, const SourceRange& literal) {
    SceneParameter parameter;
    parameter.role = ParameterRole::declared;
    parameter.name = name;
    parameter.group = "#declare";
    parameter.value = value;
    const SliderRange range = sliderRangeAround(value);
    parameter.minimum = range.minimum;
    parameter.maximum = range.maximum;
    parameter.range = literal;
    parameter.text = std::string(tokens_.context().sources.slice(literal));
    const int index = tokens_.context().addParameter(std::move(parameter));
    tokens_.context().parameterAt[literal.begin] = index;
    return index;
}

void DefinitionReader::undefine() {
    const Token name = tokens_.nextName();
    ParseContext& context = tokens_.context();
    if (name.kind != TokenKind::word || isReservedWord(name.text)) {
        context.error("bad-name", name.range, "Expected the name that `#undef` is to forget.");
        return;
    }
    if (!context.symbols.find(name.text) && isPredeclared(name.text, context))
        context.replacedConstants.emplace(name.text);
    else if (!context.symbols.undefine(name.text))
        context.warning("unknown-name", name.range,
                        "`" + std::string(name.text) + "` is not declared, so `#undef` does nothing.");
}

void DefinitionReader::macroHead() {
    const Token name = tokens_.nextName();
    ParseContext& context = tokens_.context();
    if (name.kind != TokenKind::word || isReservedWord(name.text)) {
        context.error("bad-name", name.range, "Expected the name of the macro behind `#macro`.");
        return;
    }
    macro_.name = std::string(name.text);
    Token token = tokens_.nextName();
    bool understood = token.is("(");
    while (understood) {
        token = tokens_.nextName();
        if (token.is(")")) break;
        if (token.is(",")) continue;
        understood = token.kind == TokenKind::word;
        if (!understood || token.text == "optional") continue;
        if (isReservedWord(token.text))
            context.error("bad-name", token.range,
                          "`" + std::string(token.text) +
                              "` is a word of the language; a parameter needs another name.");
        macro_.parameterNames.emplace_back(token.text);
    }
    if (!understood) {
        context.error("expected-token", token.range,
                      "Expected the parameters of the macro `" + macro_.name + "` as `(A, B)` or `()`.");
        macro_.name.clear();
        return;
    }
    macro_.body = {token.range.file, token.range.end, token.range.end};
}

void DefinitionReader::defineMacro(const SourceRange& end, bool closed) {
    if (!closed)
        tokens_.context().error("unclosed-directive", directive_,
                                "`#macro` is never closed; expected `#end`.");
    if (macro_.name.empty()) return;
    macro_.body.end = end.begin;
    const std::string name = macro_.name;
    tokens_.context().symbols.declare(name, {std::make_shared<const MacroValue>(std::move(macro_))});
}

}  // namespace isoscope
