// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/command_line.h"
#include "core/language/parse.h"
#include "core/render/render_request.h"
#include "core/shapes/trace_context.h"
#include "core/text/csv_table.h"

namespace isoscope::cli {

/// The arguments that every command that reads a scene understands.
struct SceneArguments {
    std::string file;
    std::vector<std::string> declarations;  ///< NAME=VALUE
    int frame = -1;
    int finalFrame = -1;
    std::optional<double> clock;
    std::vector<std::string> readableFolders;  ///< that a scene may read besides its own and the library
    double timeLimit = 20;                     ///< seconds that the text may be read for

    /// Who says which frame and clock it is.
    enum class Moment { byOptions, ofCommand };
    /// Adds the options to a command; this must live as long as the command line.
    void addTo(Command& command, Moment moment = Moment::byOptions);
};

/// Reads the scene; where a frame or clock is given, its timeline moves its numbers. `width` and `height`
/// become image_width and image_height. Throws UsageError for a declaration that cannot be read.
ParseResult loadScene(const SceneArguments& arguments, int width = 800, int height = 600);

/// Prints diagnostics of at least this severity to standard error.
void printDiagnostics(const Diagnostics& diagnostics, const SourceLibrary& sources, bool errorsOnly);

/// Reads a CSV file that must have these columns; otherwise says what is missing on standard error.
std::optional<CsvTable> loadTable(const std::string& file, const std::vector<std::string>& neededColumns);

/// The solver named on the command line.
RootFinder rootFinder(const std::string& name);

/// The picture of a scene without errors, by the root finder of that name.
RenderRequest pictureOf(const ParseResult& parsed, int width, int height, const std::string& solver);

/// Adds `--solver certified|lipschitz`.
void addSolverOption(Command& command, std::string& solver);

/// What a ray or a point is tested against: the declared object `name`, or every object of the scene when
/// `name` is empty. Null, with a message on standard error, when there is none.
ShapePointer shapeToTest(const ParseResult& parsed, const std::string& name);

}  // namespace isoscope::cli
