// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/language/symbol_table.h"
#include "core/scene/scene.h"
#include "core/text/diagnostic.h"

namespace isoscope {

/// What a parse is told from outside.
struct ParseOptions {
    std::filesystem::path file;                       ///< name of the text; includes are searched beside it
    std::vector<std::filesystem::path> libraryPaths;  ///< searched for includes that are not the program's own
    double clock = 0;
    bool clockOn = false;                             ///< an animation frame was asked for
    int frameNumber = 0;
    int initialFrame = 1;
    int finalFrame = 1;
    int imageWidth = 800;
    int imageHeight = 600;
    int noiseGenerator = 2;                           ///< in force until global_settings says otherwise
    std::map<std::string, double> declarations;       ///< --declare NAME=VALUE, in force before the text
    std::size_t stepBudget = 20'000'000;              ///< tokens read before loops are cut off with a message
    std::size_t diagnosticLimit = 200;                ///< further ones are counted, not kept
};

/// What all parts of one parse share.
struct ParseContext {
    explicit ParseContext(ParseOptions parseOptions)
        : options(std::move(parseOptions)), noiseGenerator(options.noiseGenerator) {}

    ParseOptions options;
    SourceLibrary sources;
    Diagnostics diagnostics;
    SymbolTable symbols;
    /// The sliders found so far; NumberValue::parameter and slots refer to it.
    std::vector<SceneParameter> parameters;
    std::vector<double> parameterTable;
    /// The parameter whose range begins at this byte of the user's text: a literal in a loop is one slider.
    std::unordered_map<std::uint32_t, int> parameterAt;
    /// Whether built-ins may be called without functions.inc, as nobody could have included it.
    bool builtinsKnown = false;
    /// Operations in all functions of the text so far; there is a limit to what it may ask for.
    std::size_t functionNodes = 0;
    /// Statements around the one being read; see NestingGuard.
    int nesting = 0;
    /// Operations copied by calls of declared functions, for the same reason.
    std::size_t functionCopies = 0;
    int languageVersion = 370;  ///< 100 times the #version in force
    int noiseGenerator = 2;     ///< of global_settings, for functions declared later

    /// Adds a diagnostic; repeated ones (same id, place and text) are dropped.
    void report(Diagnostic diagnostic);
    void error(std::string id, const SourceRange& range, std::string message, std::string hint = {});
    void warning(std::string id, const SourceRange& range, std::string message, std::string hint = {});
    void leftOut(const SourceRange& range, std::string what);
};

}  // namespace isoscope
