// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/virtualight/scene_reader.h"

#include <algorithm>
#include <array>
#include <chrono>

#include "core/evaluate/tape/loop_stop.h"
#include "core/language/scene_finish.h"
#include "core/language/tokens/lexer.h"
#include "core/virtualight/document_parser.h"
#include "core/virtualight/object_maker.h"

namespace isoscope {

namespace virtualight {

namespace {

std::string nameOf(const ParseOptions& options) {
    return options.file.empty() ? std::string("scene") : options.file.filename().string();
}

std::string endingOf(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c; });
    return ending;
}

/// What stands in for the shaders that are not simulated.
Material plainMaterial() {
    Material material;
    material.pigment = SolidPigment{plainColor, {}};
    return material;
}

ParseResult parseOnce(const std::string& text, const ParseOptions& options) {
    ParseContext context(options);
    const LoopStop loops(context.options.stop);
    const std::uint32_t file = context.sources.add(nameOf(options), text);
    const Document document = DocumentParser(context, file).parse();
    ObjectMaker maker(context);
    SceneDraft draft;
    draft.defaultMaterials = {plainMaterial()};
    for (const NodePointer& node : document.shown) {
        if (context.stopAsked()) break;
        if (const ObjectPointer object = maker.make(*node)) draft.objects.push_back({object, 0});
    }
    for (const NodePointer& node : document.declared) {
        if (context.stopAsked()) break;
        // Of a text that shows nothing the last one is shown. Others may be meant for a Solid with a Bound.
        const bool shown = document.shown.empty() && node == document.declared.back();
        const std::size_t said = context.diagnostics.size();
        if (ObjectPointer object = maker.make(*node))
            context.symbols.declare(node->name, Value{std::move(object)});
        else if (!shown)
            context.diagnostics.resize(said);
    }
    finishScene(draft, context);
    ParseResult result;
    result.notation = Notation::virtualight;
    result.scene = std::make_shared<const Scene>(std::move(draft.scene));
    result.diagnostics = std::move(context.diagnostics);
    result.symbols = std::make_shared<const SymbolTable>(std::move(context.symbols));
    result.sources = std::make_shared<const SourceLibrary>(std::move(context.sources));
    return result;
}

ParseResult failed(const std::string& text, const ParseOptions& options, const std::string& reason) {
    ParseResult result;
    result.notation = Notation::virtualight;
    const auto sources = std::make_shared<SourceLibrary>();
    sources->add(nameOf(options), text);
    result.sources = sources;
    result.scene = std::make_shared<Scene>();
    result.symbols = std::make_shared<SymbolTable>();
    result.diagnostics.push_back({Severity::error,
                                  "out-of-resources",
                                  {},
                                  "The text could not be read to its end: " + reason + ".",
                                  {},
                                  {}});
    return result;
}

}  // namespace

bool isVirtualight(const std::filesystem::path& file, std::string_view text) {
    const std::string ending = endingOf(file);
    if (ending == ".vl" || ending == ".vib") return true;
    if (ending == ".pov" || ending == ".inc") return false;
    Lexer lexer(text, 0);
    const Token first = lexer.next(), second = lexer.next();
    if (first.is("Shape") || first.is("Solid")) return second.is("[");
    return (first.is("Declare") || first.is("static")) && second.kind == TokenKind::word &&
           lexer.next().is("=");
}

ParseResult parseVirtualight(std::string text, ParseOptions options) {
    const auto start = std::chrono::steady_clock::now();
    ParseResult result;
    try {
        result = parseOnce(text, options);
    } catch (const std::exception& error) {
        result = failed(text, options, error.what());
    }
    result.options = withoutStop(std::move(options));
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

Document readDocument(std::string text, const ParseOptions& options, Diagnostics* diagnostics) {
    try {
        ParseContext context(options);
        const std::uint32_t file = context.sources.add(nameOf(options), std::move(text));
        Document document = DocumentParser(context, file).parse();
        if (diagnostics) *diagnostics = std::move(context.diagnostics);
        return document;
    } catch (const std::exception&) {
        return {};
    }
}

}  // namespace virtualight

}  // namespace isoscope
