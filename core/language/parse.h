// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "core/language/parse_context.h"
#include "core/scene/scene.h"

namespace isoscope {

/// The language that a text is written in; core/virtualight reads VirtuaLight's.
enum class Notation { povray, virtualight };

/// What a text was understood as. `scene` is always there; after errors it holds what was understood.
struct ParseResult {
    std::shared_ptr<const Scene> scene;
    Diagnostics diagnostics;
    std::shared_ptr<const SourceLibrary> sources;
    /// The declared names with their values, for tools that look objects up by name.
    std::shared_ptr<const SymbolTable> symbols;
    double seconds = 0;
    /// The names that could be seen where the isosurface ended that ParseOptions::namesOfIsosurface asked
    /// for: in a loop or macro they are others than at the end of the text.
    std::map<std::string, Value> namesAtIsosurface;
    /// What the text writes to files, by their names as it says them. Nothing has been written yet: the
    /// caller asks the user and calls writeBeside().
    std::map<std::string, std::string> writtenFiles;
    ParseOptions options;  ///< those it was made with
    Notation notation = Notation::povray;

    /// No errors; there may be warnings.
    bool ok() const { return !hasErrors(diagnostics); }
};

/// Reads a scene. Never throws, never hangs, for any bytes.
ParseResult parseScene(std::string text, ParseOptions options = {});

/// Reads the file and parses it; a file that cannot be read is a diagnostic.
ParseResult parseSceneFile(const std::filesystem::path& file, ParseOptions options = {});

/// The shape of a declared object ("Shape" in `#declare Shape = ...`), in world coordinates; null when the
/// name is unknown or no object.
ShapePointer declaredShape(const ParseResult& parsed, const std::string& name);

/// The body of one function (what stands between the braces), with `prelude` in force before it.
/// `parameterNames` empty means x, y, z.
struct ParsedFunction {
    FunctionValue value;
    Diagnostics diagnostics;
    std::shared_ptr<const SourceLibrary> sources;
    std::vector<double> parameterTable;

    /// Whether there is a function, and no error.
    bool ok() const { return value.function.valid() && !hasErrors(diagnostics); }
};
/// Never throws. Built-ins are known without functions.inc. In `sources` the body is text 0, `prelude` 1.
ParsedFunction parseFunction(const std::string& body, const std::string& prelude = {},
                             ParseOptions options = {}, std::vector<std::string> parameterNames = {});

}  // namespace isoscope
