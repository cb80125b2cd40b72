// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/scene_parser.h"

#include <algorithm>
#include <array>

#include "core/language/camera_parser.h"
#include "core/language/expressions/expression_parser.h"
#include "core/language/functions/bare_formula.h"
#include "core/language/functions/function_parser.h"
#include "core/language/light_parser.h"
#include "core/language/objects/object_parser.h"
#include "core/language/objects/shape_parser.h"
#include "core/language/objects/spline_parser.h"
#include "core/language/objects/transform_parser.h"
#include "core/language/statement_description.h"
#include "core/language/textures/finish_parser.h"
#include "core/language/textures/interior_parser.h"
#include "core/language/textures/pigment_parser.h"
#include "core/language/textures/texture_parser.h"
#include "core/language/tokens/block_words.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/language/tokens/unknown_name.h"
#include "core/language/tokens/words.h"

namespace isoscope {

namespace {

/// What may begin a statement: the scene's own, and macros.
std::vector<std::string> statementWords(const SymbolTable& symbols) {
    std::vector<std::string> words = wordsOfBlock("");
    symbols.forEach([&](const std::string& name, const Value& value) {
        if (std::holds_alternative<std::shared_ptr<const MacroValue>>(value.data)) words.push_back(name);
    });
    return words;
}

}  // namespace

SceneParser::SceneParser(TokenStream& tokens, SceneDraft& draft) : tokens_(tokens), draft_(draft) {
    tokens_.setValueParser([this](TokenStream&) { return parseValue(); });
    tokens_.setDefaultParser([this](TokenStream&) { parseDefault(); });
}

void SceneParser::parse() {
    while (tokens_.peek().kind != TokenKind::end) parseStatement();
}

void SceneParser::parseStatement() {
    const Token token = tokens_.peek();
    if (tokens_.accept(";"))
        return warnOfSuperfluous(tokens_.context(), token.range, "takes no `;` behind a statement.");
    const Diagnostics& told = tokens_.context().diagnostics;
    const auto before = static_cast<std::ptrdiff_t>(told.size());
    if (token.kind == TokenKind::word && parseKnown(token))
        mistaken_ = std::any_of(told.begin() + before, told.end(), [](const Diagnostic& diagnostic) {
            return diagnostic.severity == Severity::error;
        });
    else
        parseUnknown(token);
}

bool SceneParser::parseKnown(const Token& word) {
    if (ObjectParser::isObject(word.text)) {
        parseObject();
        return true;
    }
    if (tokens_.accept("camera"))
        parseCamera(word);
    else if (tokens_.accept("light_source"))
        parseLight();
    else if (tokens_.accept("background"))
        parseBackground();
    else if (tokens_.accept("default"))
        parseDefault();
    else if (tokens_.accept("declare") || tokens_.accept("include"))
        runBareDirective(word);
    else if (const StatementDescription* statement = findStatement(word.text)) {
        tokens_.next();
        statement->parse(tokens_, draft_);
    } else
        return parseName();
    return true;
}

void SceneParser::runBareDirective(const Token& word) {
    const std::string directive = "#" + std::string(word.text);
    std::vector<QuickFix> fixes;
    if (word.range.file == 0)
        fixes.push_back({"Add `#`", {word.range.file, word.range.begin, word.range.begin}, "#"});
    tokens_.context().report({Severity::warning,
                              "missing-hash",
                              word.range,
                              "A `#` is missing in front of `" + std::string(word.text) + "`.",
                              "write `" + directive + "`",
                              {},
                              std::move(fixes)});
    tokens_.runDirective(word);
}

bool SceneParser::parseName() {
    const std::optional<ObjectPointer> object = ObjectParser(tokens_, draft_).parseName();
    if (object) addObject(*object);
    return object.has_value();
}

void SceneParser::parseLight() {
    LightParser parser(tokens_, &draft_);
    draft_.scene.lights.push_back(parser.parse());
    addObject(parser.looks());
}

void SceneParser::parseObject() { addObject(ObjectParser(tokens_, draft_).parse()); }

void SceneParser::addObject(const ObjectPointer& object) {
    if (!object) return;
    draft_.shapeCount += object->shapeCount;
    if (draft_.shapeCount > ObjectDescription::shapeLimit) {
        tokens_.context().error("too-large", object->range,
                                "The scene has more than " + std::to_string(ObjectDescription::shapeLimit) +
                                    " shapes; this one is left out.");
        draft_.shapeCount -= object->shapeCount;
        return;
    }
    draft_.objects.push_back({object, draft_.defaultMaterials.size() - 1});
}

void SceneParser::parseCamera(const Token& word) {
    draft_.scene.camera = CameraParser(tokens_).parse();
    draft_.hasCamera = true;
    const SourceRange range = rangeSince(word.range, tokens_);
    draft_.scene.cameraRange.reset();
    if (range.file == 0 && range.end > word.range.end) draft_.scene.cameraRange = range;
}

void SceneParser::parseBackground() {
    if (!tokens_.expect("{", "to begin `background`")) return;
    Color color = ExpressionParser(tokens_).parseColor();
    // What is transmitted shows nothing behind it: black.
    const double share = 1 - color.transmit;
    color.red *= share, color.green *= share, color.blue *= share;
    draft_.scene.background = color;
    if (tokens_.accept("}") || (closeUnclosed(tokens_, "background") && tokens_.accept("}"))) return;
    tokens_.context().error("unexpected-token", tokens_.peek().range, "Expected `}` to close `background`.");
    tokens_.skipBlock();
}

void SceneParser::parseUnknown(const Token& token) {
    ParseContext& context = tokens_.context();
    if (isWordFor(WordUse::notSimulated, token.text)) {
        tokens_.next();
        if (tokens_.accept("{")) tokens_.skipBlock();
        reportLeftOut(context, token.range, notSimulatedSentence(token.text));
        return;
    }
    if (token.is("}")) {
        if (!mistaken_) context.error("unbalanced-brace", token.range, "This `}` closes nothing.");
        mistaken_ = true;
        tokens_.next();
        return;
    }
    if (passFormula(token)) return;
    tokens_.next();
    const bool isMisspelt = tokens_.peek().is("{") && !isReservedWord(token.text);
    tokens_.pushBack(token);
    if (!mistaken_ || isMisspelt)
        reportUnknownWord(context, "unknown-statement", token,
                          "Expected a statement such as `isosurface`, but found " + describe(token) + ".", "",
                          [&context] { return statementWords(context.symbols); });
    mistaken_ = !isMisspelt;
    tokens_.skipStatement();
}

bool SceneParser::passFormula(const Token& first) {
    ParseContext& context = tokens_.context();
    if (first.range.file >= context.sources.size()) return false;
    const std::string_view text = context.sources[first.range.file].text();
    // What a mistake left of another statement does not begin a line.
    const std::string_view before = text.substr(0, first.range.begin);
    const std::size_t last = before.find_last_not_of(" \t;");
    if (last != std::string_view::npos && before[last] != '\n') return false;
    const auto isNumber = [&context](std::string_view name) {
        const Value* value = context.symbols.find(name);
        return value && std::holds_alternative<NumberValue>(value->data);
    };
    const std::optional<BareFormula> formula = readBareFormula(text, first.range.begin, isNumber);
    if (!formula) return false;
    const SourceRange range{first.range.file, first.range.begin, static_cast<std::uint32_t>(formula->end)};
    const std::size_t complaints = context.diagnostics.size();
    while (tokens_.peek().range.file == range.file && tokens_.peek().range.begin < range.end &&
           tokens_.peek().kind != TokenKind::end)
        tokens_.next();
    if (tokens_.cutOff()) return true;  // why has been told
    // Characters that only the formula has are no mistakes of their own.
    std::erase_if(context.diagnostics, [&, i = std::size_t(0)](const Diagnostic& diagnostic) mutable {
        return i++ >= complaints && diagnostic.range.begin < range.end;
    });
    context.error("bare-formula", range, "A formula alone shows nothing: a scene is made of objects.",
                  "write isosurface { function { " + formula->function + " } ... }");
    return true;
}

void SceneParser::parseDefault() {
    if (!tokens_.expect("{", "to begin `#default`")) return;
    Material material = draft_.defaultMaterials.back();
    while (!tokens_.accept("}")) {
        const Token token = tokens_.peek();
        TextureParser textures(tokens_, material);
        if (tokens_.accept("texture")) {
            Material texture = textures.parseTexture();
            if (texture.map)
                tokens_.context().error("mapped-default", token.range,
                                        "A default texture cannot be made of other textures.",
                                        "declare it, and give it to the objects");
            else
                material = std::move(texture);
        } else if (tokens_.accept("camera")) {
            draft_.scene.camera = CameraParser(tokens_).parse();
        } else if (tokens_.accept("radiosity")) {
            if (tokens_.accept("{")) tokens_.skipBlock();
        } else if (!textures.parsePart(material)) {
            if (token.kind == TokenKind::end) {
                tokens_.expect("}", "to close `#default`");
                break;
            }
            passUnknownItem(tokens_, "#default");
        }
    }
    if (tokens_.charge(TokenStream::stepsPerItem, tokens_.lastRange()))
        draft_.defaultMaterials.push_back(material);
}

/// A light that looks like something is an object of both.
Value SceneParser::parseLightValue() {
    ObjectDescription both;
    both.keyword = "light_source";
    both.range = tokens_.lastRange();
    LightParser parser(tokens_, &draft_);
    const LightSource light = parser.parse();
    if (!parser.looks()) return Value{light};
    both.lights.push_back(light);
    both.parts.push_back(parser.looks());
    both.shapeCount += parser.looks()->shapeCount;
    both.depth += parser.looks()->depth;
    return Value{ObjectPointer(std::make_shared<const ObjectDescription>(std::move(both)))};
}

std::optional<Value> SceneParser::parseValue() {
    const Token word = tokens_.peek();
    if (word.kind != TokenKind::word) return std::nullopt;
    if (ObjectParser::isObject(word.text)) return parseObjectValue(word);
    if (tokens_.accept("function")) return Value{FunctionParser(tokens_).parse()};
    if (tokens_.accept("camera")) return Value{CameraParser(tokens_).parse()};
    if (tokens_.accept("light_source")) return parseLightValue();
    if (tokens_.accept("transform")) {
        tokens_.pushBack(word);
        Transform transform;
        TransformParser(tokens_).parseModifier(transform);
        return Value{transform};
    }
    if (std::optional<Value> appearance = parseAppearance(word)) return appearance;
    if (tokens_.accept("spline")) {
        std::shared_ptr<const Spline> spline = SplineParser(tokens_).parse();
        if (!spline) return std::nullopt;
        return Value{std::move(spline)};
    }
    static constexpr std::array<std::string_view, 2> opaque{"radiosity", "material_map"};
    if (std::find(opaque.begin(), opaque.end(), word.text) != opaque.end()) {
        tokens_.next();
        if (tokens_.accept("{")) tokens_.skipBlock();
        return Value{OpaqueValue{std::string(word.text)}};
    }
    // `#declare A = B` for anything that is no expression.
    if (const Value* value = tokens_.context().symbols.find(word.text)) {
        const Value copy = *value;
        tokens_.next();
        return copy;
    }
    return std::nullopt;
}

NormalPointer SceneParser::defaultNormal() const { return draft_.defaultMaterials.back().normal; }

std::optional<Value> SceneParser::parseAppearance(const Token& word) {
    TextureParser textures(tokens_, draft_.defaultMaterials.back());
    if (tokens_.accept("texture")) return Value{textures.parseTextures()};
    if (tokens_.accept("texture_map")) return Value{textures.parseMap()};
    if (const StatementDescription* statement = findStatement(word.text);
        statement && statement->parseValue) {
        tokens_.next();
        return statement->parseValue(tokens_, draft_);
    }
    if (tokens_.accept("interior")) return Value{InteriorParser(tokens_).parse()};
    if (tokens_.accept("normal")) return Value{NormalParser(tokens_, defaultNormal()).parse(defaultNormal())};
    if (word.is("normal_map") || word.is("slope_map")) {
        tokens_.next();
        return Value{NormalParser(tokens_, defaultNormal()).parseMap(word.text)};
    }
    if (tokens_.accept("material")) return Value{textures.parseMaterial()};
    if (tokens_.accept("pigment"))
        return Value{PigmentParser(tokens_).parse(draft_.defaultMaterials.back().pigment)};
    if (tokens_.accept("density")) return Value{PigmentParser(tokens_).parse(SolidPigment{{1, 1, 1}, {}})};
    if (tokens_.accept("finish"))
        return Value{FinishParser(tokens_).parse(draft_.defaultMaterials.back().finish)};
    if (!PigmentParser::isMap(word.text)) return std::nullopt;
    tokens_.next();
    return Value{PigmentParser(tokens_).parseMap(word.text)};
}

std::optional<Value> SceneParser::parseObjectValue(const Token& word) {
    if (isUnreadShape(word.text)) {
        // Reported where it is used: include files declare many that no scene asks for.
        tokens_.next();
        if (tokens_.accept("{")) tokens_.skipBlock();
        return Value{OpaqueValue{std::string(word.text)}};
    }
    if (const ObjectPointer object = ObjectParser(tokens_, draft_).parse()) return Value{object};
    return Value{OpaqueValue{std::string(word.text)}};
}

}  // namespace isoscope
