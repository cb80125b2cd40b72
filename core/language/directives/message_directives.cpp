// SPDX-License-Identifier: GPL-3.0-or-later
// The directives of DirectiveReader that talk to the outside: versions, files and messages.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/language/directives/asset_file.h"
#include "core/language/directives/directive_reader.h"
#include "core/language/expressions/expression_parser.h"
#include "core/language/expressions/value_reader.h"
#include "core/language/scene_draft.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/language/tokens/token_stream_state.h"
#include "core/language/tokens/words.h"

namespace isoscope {

namespace {

bool isColor(const Value& value) {
    const auto* vector = std::get_if<VectorValue>(&value.data);
    return vector && vector->color;
}

/// Whether POV-Ray's `#read` puts another value in its place.
bool isReadable(const Value& value) {
    const auto* vector = std::get_if<VectorValue>(&value.data);
    return std::holds_alternative<NumberValue>(value.data) ||
           std::holds_alternative<std::string>(value.data) ||
           (vector && vector->count == 3 && !vector->color);
}

}  // namespace

void DirectiveReader::runVersion() {
    scope_->beginValue();
    // Texts for unofficial versions say so: `#version unofficial MegaPov 0.7;`
    while (tokens_.peek().kind == TokenKind::word && !ExpressionParser(tokens_).atExpression())
        tokens_.next();
    if (!ExpressionParser(tokens_).atExpression()) {
        context().error("expected-value", range_, "`#version` must be followed by a number such as 3.7.");
        return;
    }
    const std::size_t said = context().diagnostics.size();
    const double version = ExpressionParser(tokens_).parseFloat();
    tokens_.accept(";");
    if (version >= 1 && version < 10) {
        context().languageVersion = static_cast<int>(std::lround(version * 100));
        context().versionStated = true;
    } else if (context().diagnostics.size() == said) {
        context().warning("unknown-version", range_,
                          "There is no such version of the scene language; expected a number such as 3.7.");
    }
}

void DirectiveReader::runInclude() {
    Lexer& lexer = tokens_.state_->frames.back().lexer;
    const std::uint32_t before = lexer.offset();
    const Token literal = lexer.next();
    std::string name;
    SourceRange site = {range_.file, range_.begin, literal.range.end};
    if (literal.kind == TokenKind::string) {
        // A literal keeps its backslashes: they separate folders.
        name = rawString(literal.text);
        tokens_.state_->lastRange = literal.range;
    } else {
        lexer.seek(before);
        scope_->beginValue();
        name = ExpressionParser(tokens_).parseString();
        scope_->settle();
        site.end = tokens_.lastRange().file == site.file ? tokens_.lastRange().end : range_.end;
        if (name.empty()) return;
    }
    TokenStream::State& state = *tokens_.state_;
    if (state.frames.size() - state.macroDepth > TokenStream::includeDepthLimit) {
        tokens_.cut("too-deep", site,
                    "Reading stops here: include files include each other more than " +
                        std::to_string(TokenStream::includeDepthLimit) + " deep.");
        return;
    }
    const std::size_t textsBefore = context().sources.size();
    const IncludeLibrary::Found found = state.includes.find(name, range_.file);
    if (!found.file) {
        context().error("include-not-found", site, found.problem, found.hint);
        return;
    }
    if (name == "functions.inc") context().builtinsKnown = true;
    // POV-Ray's files of these names all say for which version they are.
    if (IncludeLibrary::isNative(name)) context().versionStated = true;
    const std::string_view text = context().sources[*found.file].text();
    // A text is kept for the places of messages, and so are the names that it alone declares.
    const bool isNew = context().sources.size() > textsBefore;
    const std::size_t kept = TokenStream::stepsPerItem + text.size() / TokenStream::charactersPerStep;
    if (isNew && !tokens_.charge(kept, site)) return;
    context().enterCall(site, {*found.file, 0, static_cast<std::uint32_t>(text.size())});
    context().symbols.pushScope();
    state.frames.push_back({Lexer(text, *found.file), false, site, {}});
}

void DirectiveReader::runDefault() {
    if (tokens_.state_->defaultParser) {
        const TokenStream::DefaultParser parse = tokens_.state_->defaultParser;
        parse(tokens_);
    } else if (tokens_.expect("{", "after `#default`")) {
        tokens_.skipBlock();
    }
}

void DirectiveReader::runMessage(Severity severity) {
    scope_->beginValue();
    std::string text = ExpressionParser(tokens_).parseString();
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
    if (text.empty() && severity == Severity::note) return;
    const std::string id = word_.substr(2, word_.size() - 3) + "-directive";
    // With #error the text itself says that it makes no sense to go on.
    if (severity == Severity::error)
        tokens_.cut(id, range_, std::move(text));
    else
        context().report({severity, id, range_, std::move(text), {}, {}});
}

void DirectiveReader::runFileOpen() {
    const std::string handle(tokens_.nextName().text);
    scope_->beginValue();
    const SourceRange start = tokens_.peek().range;
    const std::string name = ExpressionParser(tokens_).parseString();
    const SourceRange range = rangeSince(start, tokens_);
    const Token mode = tokens_.next();
    if (!mode.is("read") && !mode.is("write") && !mode.is("append"))
        return context().error("expected-token", mode.range,
                               "Expected `read`, `write` or `append` behind the name of the file.");
    if (handle.empty() || isReservedWord(handle))
        return context().error("bad-name", range_, "Expected a name for the file behind `#fopen`.");
    if (const Value* declared = context().symbols.find(handle))
        warnOfRefusal(context(), range_,
                      "wants a name that is not declared behind `#fopen`, but `" + handle + "` is " +
                          kindOf(*declared) + ".",
                      "`#fclose` or `#undef` it before");
    if (!tokens_.charge(TokenStream::stepsPerItem, range_)) return;
    if (mode.is("read")) {
        std::optional<std::string> content = contentOf(name, range);
        if (!content) {
            const AssetFile asset = findAsset(context(), name, range);
            return context().error("file-not-found", range,
                                   asset.whyNot("The file \"" + name +
                                                "\" was not found beside the scene or in the library paths."),
                                   asset.hint);
        }
        context().textFiles.openToRead(handle, name, std::move(*content));
    } else {
        // The picture is whole all the same.
        context().note("file-not-written", range_, "`" + name + "` " + std::string(TextFiles::keptNote));
        if (mode.is("append") && !context().textFiles.written(name))
            if (const std::optional<std::string> before = contentOf(name, range)) {
                context().textFiles.openToWrite(handle, name, false);
                context().textFiles.write(handle, *before);
            }
        context().textFiles.openToWrite(handle, name, mode.is("append"));
    }
    context().symbols.declare(handle, Value{OpaqueValue{"file"}});
}

std::optional<std::string> DirectiveReader::contentOf(const std::string& name, const SourceRange& range) {
    if (const std::string* written = context().textFiles.written(name)) return *written;
    const auto file = findAsset(context(), name, range);
    std::error_code failed;
    if (!file || std::filesystem::file_size(*file, failed) > TextFiles::sizeLimit || failed)
        return std::nullopt;
    std::ifstream input(*file, std::ios::binary);
    if (!input) return std::nullopt;
    return std::string{std::istreambuf_iterator<char>(input), {}};
}

void DirectiveReader::runFileClose() {
    const std::string handle(tokens_.nextName().text);
    context().textFiles.close(handle);
    // At the end of a file `#read` has forgotten the name already.
    context().symbols.undefine(handle);
}

void DirectiveReader::runFileRead() {
    if (!tokens_.expect("(", "after `#read`")) return;
    const Token handle = tokens_.nextName();
    bool ended = false;
    for (;;) {
        Token name = tokens_.nextName();
        if (name.is(",")) name = tokens_.nextName();
        for (; name.is(","); name = tokens_.nextName())
            warnOfSuperfluous(context(), name.range, "takes one comma here.");
        if (name.is(")")) return;
        if (name.kind != TokenKind::word || isReservedWord(name.text)) {
            context().error("expected-token", name.range,
                            "Expected the name of a variable, or `)` to close `#read`.");
            return;
        }
        std::optional<ElementPlace> element;
        if (tokens_.peek().is("[")) {
            const Value* whole = context().symbols.find(name.text);
            const auto* array = whole ? std::get_if<std::shared_ptr<ArrayValue>>(&whole->data) : nullptr;
            if (array) element = ExpressionParser(tokens_).parseElementPlace(*array);
            if (!element) return;
        }
        if (!ended) ended = readFromFile(handle, name, element ? &element->value() : nullptr);
    }
}

bool DirectiveReader::readFromFile(const Token& handle, const Token& name, Value* element) {
    const std::string file(handle.text);
    std::optional<TextFiles::Read> read = context().textFiles.read(file);
    if (!read) {
        context().error("not-open", handle.range,
                        "`" + file + "` is not the name of a file that is open for reading.");
        // Or a loop that waits for the end of the file would have none.
        context().textFiles.close(file);
        context().symbols.undefine(file);
        return true;
    }
    if (!read->wrong.empty())
        context().error("bad-value", name.range,
                        "\"" + read->file + "\" has `" + read->wrong +
                            "` where a float, a vector or a string must stand.",
                        "`#read` knows constants alone: -1.5, <1, 2, 3>, \"text\"");
    if (!read->lost.empty())
        context().warning("lost-value", name.range,
                          "\"" + read->file + "\" has `" + read->lost +
                              "` behind a value; one word there is passed over, as by POV-Ray.",
                          "put a comma behind each value");
    const Value* before = element ? element : context().symbols.find(name.text);
    if (before && !isReadable(*before))
        warnOfRefusal(context(), name.range,
                      "reads into new names, floats, vectors of three and strings, but this is " +
                          kindOf(*before) + ".",
                      "`#undef` it before, or give the element a value");
    if (read->value && element)
        *element = std::move(*read->value);
    else if (read->value)
        context().symbols.declare(std::string(name.text), std::move(*read->value));
    if (read->atEnd) {
        context().textFiles.close(file);
        context().symbols.undefine(file);
    }
    return read->atEnd;
}

void DirectiveReader::runFileWrite() {
    if (!tokens_.expect("(", "after `#write`")) return;
    const Token handle = tokens_.nextName();
    // POV-Ray forgives missing commas and further ones.
    for (;;) {
        while (tokens_.accept(",")) {
        }
        const Token first = tokens_.peek();
        if (first.is(")") || first.kind == TokenKind::end) break;
        const SourceRange start = first.range;
        const std::optional<Value> value = ValueReader(tokens_).read();
        if (!value) break;
        const std::optional<std::string> text = writtenForm(*value);
        const Value* named = first.kind == TokenKind::word ? context().symbols.find(first.text) : nullptr;
        const bool counts = named && !std::holds_alternative<std::shared_ptr<ArrayValue>>(named->data);
        if (first.kind == TokenKind::word && isColor(counts ? *named : *value))
            warnOfRefusal(context(), rangeSince(start, tokens_), "writes no colours to files.",
                          "write its components as a vector");
        if (!text)
            context().error("bad-value", rangeSince(start, tokens_),
                            "Files hold floats, vectors and strings, but this is " + kindOf(*value) + ".");
        else if (!context().textFiles.write(std::string(handle.text), *text))
            context().error("not-open", handle.range,
                            "`" + std::string(handle.text) +
                                "` is not the name of a file that is open for writing, or it is full.");
        else if (!tokens_.charge(text->size() / 16, start))
            break;
    }
    tokens_.expect(")", "to close `#write`");
}

}  // namespace isoscope
