// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/parse.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>
#include <utility>

#include "core/evaluate/tape/loop_stop.h"
#include "core/language/functions/function_parser.h"
#include "core/language/objects/object_description.h"
#include "core/language/scene_builder.h"
#include "core/language/scene_finish.h"
#include "core/language/scene_parser.h"
#include "core/language/sliders/slider_note.h"
#include "core/language/version_lens.h"
#include "core/text/scene_file.h"

namespace isoscope {

namespace {

ParseResult failedResult(const std::string& name, const std::string& id, const std::string& message) {
    ParseResult result;
    const auto sources = std::make_shared<SourceLibrary>();
    sources->add(name, {});
    result.sources = sources;
    result.scene = std::make_shared<Scene>();
    result.symbols = std::make_shared<SymbolTable>();
    result.diagnostics.push_back({Severity::error, id, {}, message, {}, {}});
    return result;
}

std::string nameOf(const ParseOptions& options) {
    return options.file.empty() ? std::string("scene") : options.file.filename().string();
}

/// `limits` are taken for the time of reading and given back.
ParseResult parseOnce(const std::string& text, const ParseOptions& options,
                      std::unique_ptr<const ReadingLimits>& limits) {
    ParseContext context(options, std::move(limits));
    const LoopStop loops(context.options.stop);
    const std::uint32_t file = context.sources.add(nameOf(options), text);
    SceneDraft draft;
    {
        TokenStream tokens(context, file);
        SceneParser(tokens, draft).parse();
    }
    finishScene(draft, context);
    ParseResult result;
    result.scene = std::make_shared<const Scene>(std::move(draft.scene));
    result.diagnostics = std::move(context.diagnostics);
    result.namesAtIsosurface = std::move(context.namesAtIsosurface);
    result.writtenFiles = context.textFiles.takeWritten();
    result.symbols = std::make_shared<const SymbolTable>(std::move(context.symbols));
    result.sources = std::make_shared<const SourceLibrary>(std::move(context.sources));
    limits = std::move(context.limits);
    return result;
}

/// Says which notes of sliders are none, though they begin as such.
void addSliderNotes(ParseResult& result) {
    if (result.sources->size() == 0) return;
    std::set<std::size_t> seen;  // a number may be read again and again
    for (const SceneParameter& parameter : result.scene->parameters) {
        if (parameter.range.file != 0 || parameter.implied || parameter.expression) continue;
        if (!seen.insert(parameter.range.end).second) continue;
        const auto mistake = sliderNoteMistake((*result.sources)[0].text(), parameter.range.end);
        if (!mistake) continue;
        const SourceRange range{0, static_cast<std::uint32_t>(mistake->begin),
                                static_cast<std::uint32_t>(mistake->end)};
        result.diagnostics.push_back({Severity::note,
                                      "slider-note",
                                      range,
                                      "This note of a slider is passed over. " + mistake->reason,
                                      "for example `[0.1:2:0.1 log]`",
                                      {}});
    }
}

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

ParseResult parseScene(std::string text, ParseOptions options) {
    const auto start = std::chrono::steady_clock::now();
    ParseResult result;
    try {
        std::unique_ptr<const ReadingLimits> limits = limitsOf(options);
        result = parseOnce(text, options, limits);
        const bool ranOut = std::any_of(
            result.diagnostics.begin(), result.diagnostics.end(),
            [](const Diagnostic& said) { return said.id == "time-limit" || said.id == "memory-limit"; });
        const int generator = hasOldNoise(result) ? 1 : result.scene->settings.noiseGenerator;
        if (generator != options.noiseGenerator && !ranOut) {
            // POV-Ray's functions follow the setting of the whole scene, wherever it stands.
            // What was read before makes room first: both readings share one budget.
            options.noiseGenerator = generator;
            result = {};
            result = parseOnce(text, options, limits);
        }
        addVersionNotes(result);
        addSliderNotes(result);
    } catch (const std::exception& error) {
        result = failedResult(nameOf(options), "out-of-resources",
                              std::string("The text could not be read to its end: ") + error.what() + ".");
    }
    result.options = withoutStop(std::move(options));
    result.seconds = secondsSince(start);
    return result;
}

ParseResult parseSceneFile(const std::filesystem::path& file, ParseOptions options) {
    if (options.file.empty()) options.file = file;
    std::string problem;
    if (std::optional<std::string> text = readSceneText(file, problem))
        return parseScene(std::move(*text), std::move(options));
    return failedResult(nameOf(options), "unreadable-file", problem);
}

ShapePointer declaredShape(const ParseResult& parsed, const std::string& name) {
    if (!parsed.symbols) return nullptr;
    const Value* value = parsed.symbols->find(name);
    const auto* object = value ? std::get_if<ObjectPointer>(&value->data) : nullptr;
    if (!object || !*object) return nullptr;
    Scene materials;
    return SceneBuilder(materials).shape(**object);
}

ParsedFunction parseFunction(const std::string& body, const std::string& prelude, ParseOptions options,
                             std::vector<std::string> parameterNames) {
    ParsedFunction result;
    try {
        ParseContext context(std::move(options));
        const LoopStop loops(context.options.stop);
        context.builtinsKnown = true;
        const std::uint32_t bodyFile = context.sources.add("function", body);
        if (!prelude.empty()) {
            const std::uint32_t preludeFile = context.sources.add("prelude", prelude);
            SceneDraft draft;
            TokenStream tokens(context, preludeFile);
            SceneParser(tokens, draft).parse();
        }
        TokenStream tokens(context, bodyFile);
        result.value = FunctionParser(tokens).parseBody(std::move(parameterNames), true);
        result.parameterTable = context.parameterTable;
        result.diagnostics = std::move(context.diagnostics);
        result.sources = std::make_shared<const SourceLibrary>(std::move(context.sources));
    } catch (const std::exception& error) {
        const auto sources = std::make_shared<SourceLibrary>();
        sources->add("function", body);
        result = {};
        result.sources = sources;
        result.diagnostics.push_back({Severity::error,
                                      "out-of-resources",
                                      {},
                                      std::string("The function could not be read: ") + error.what() + ".",
                                      {},
                                      {}});
    }
    return result;
}

}  // namespace isoscope
