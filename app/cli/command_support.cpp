// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_support.h"

#include <iostream>

#include "core/animation/animation.h"
#include "core/exchange/read_scene.h"
#include "core/language/directives/library_paths.h"
#include "core/shapes/combined/csg.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

void SceneArguments::addTo(Command& command, Moment moment) {
    command.option("scene", file, "Scene file (.pov, .inc or .vl)").required();
    command.option("--declare", declarations, "NAME=VALUE, in force before the text (repeatable)")
        .oneValueEach();
    if (moment == Moment::byOptions) {
        command.option("--frame", frame, "Animation frame: sets frame_number");
        command.option("--final-frame", finalFrame, "Last frame of the animation: scales clock to 0..1");
        command.option("--clock", clock, "Value of clock");
    }
    command
        .option("--allow-read", readableFolders,
                "Folder that the scene may read besides its own and the library paths (repeatable)")
        .oneValueEach();
    command.option("--time-limit", timeLimit, "Seconds that the text may be read for")
        .positive()
        .showDefault();
}

namespace {

/// Puts NAME=VALUE into the options; false when it is not of that form.
bool addDeclaration(const std::string& text, ParseOptions& options) {
    const std::size_t sign = text.find('=');
    if (sign == std::string::npos || sign == 0 || sign + 1 == text.size()) return false;
    char* end = nullptr;
    const double value = leadingNumber(text.c_str() + sign + 1, &end);
    if (*end != '\0') return false;
    options.declarations[text.substr(0, sign)] = value;
    return true;
}

}  // namespace

ParseResult loadScene(const SceneArguments& arguments, int width, int height) {
    ParseOptions options;
    options.libraryPaths = installedLibraryPaths();
    options.imageWidth = width;
    options.imageHeight = height;
    options.restrictedReading = true;
    options.readableFolders.assign(arguments.readableFolders.begin(), arguments.readableFolders.end());
    options.secondsBudget = arguments.timeLimit;
    if (arguments.frame >= 0) {
        options.clockOn = true;
        options.frameNumber = arguments.frame;
        options.finalFrame = std::max(arguments.finalFrame, arguments.frame);
        if (arguments.finalFrame > 1)
            options.clock = double(arguments.frame - 1) / double(options.finalFrame - 1);
    }
    if (arguments.clock) {
        options.clock = *arguments.clock;
        options.clockOn = true;
    }
    for (const std::string& declaration : arguments.declarations)
        if (!addDeclaration(declaration, options))
            throw UsageError("--declare: `" + declaration + "` is not of the form NAME=NUMBER");

    // Without a moment the numbers are those of the text, whatever its timeline says.
    if (options.clockOn) return readFileAtClock(arguments.file, options);
    ParseResult parsed = readSceneFile(arguments.file, options);
    addTimelineWarnings(parsed);
    return parsed;
}

void printDiagnostics(const Diagnostics& diagnostics, const SourceLibrary& sources, bool errorsOnly) {
    for (const Diagnostic& diagnostic : diagnostics)
        if (!errorsOnly || diagnostic.severity == Severity::error) std::cerr << toReport(diagnostic, sources);
}

std::optional<CsvTable> loadTable(const std::string& file, const std::vector<std::string>& neededColumns) {
    std::optional<CsvTable> table = CsvTable::read(file);
    if (!table) {
        std::cerr << file << ": error: the file cannot be read\n";
        return std::nullopt;
    }
    if (const std::optional<std::size_t> line = table->unclosedQuote()) {
        std::cerr << file << ':' << *line << ": error: this quote is never closed\n";
        return std::nullopt;
    }
    for (const std::string& column : neededColumns) {
        if (table->hasColumn(column)) continue;
        std::cerr << file << ":1:1: error: the column `" << column << "` is missing\n";
        return std::nullopt;
    }
    return table;
}

RootFinder rootFinder(const std::string& name) {
    return name == "certified" ? RootFinder::certified : RootFinder::lipschitz;
}

RenderRequest pictureOf(const ParseResult& parsed, int width, int height, const std::string& solver) {
    RenderRequest request;
    request.scene = parsed.scene;
    request.camera = parsed.scene->camera;
    request.width = width;
    request.height = height;
    request.rootFinder = rootFinder(solver);
    return request;
}

void addSolverOption(Command& command, std::string& solver) {
    command.option("--solver", solver, "Root finder for isosurfaces")
        .oneOf({"certified", "lipschitz"})
        .showDefault();
}

ShapePointer shapeToTest(const ParseResult& parsed, const std::string& name) {
    if (!name.empty()) {
        ShapePointer shape = declaredShape(parsed, name);
        if (!shape) std::cerr << "error: the scene declares no object called `" << name << "`\n";
        return shape;
    }
    std::vector<ShapePointer> shapes;
    for (const SceneObject& object : parsed.scene->objects) shapes.push_back(object.shape);
    if (shapes.empty()) {
        std::cerr << "error: the scene shows no object\n";
        return nullptr;
    }
    return shapes.size() == 1 ? shapes.front()
                              : std::make_shared<Csg>(CsgOperation::union_, std::move(shapes));
}

}  // namespace isoscope::cli
