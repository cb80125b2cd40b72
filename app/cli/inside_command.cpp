// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"

namespace isoscope::cli {

namespace {

struct InsideArguments {
    SceneArguments scene;
    std::string points;
    std::string object;
};

ExitStatus testPoints(const InsideArguments& arguments) {
    const std::optional<CsvTable> table = loadTable(arguments.points, {"x", "y", "z"});
    if (!table) return inputHasErrors;
    const ParseResult parsed = loadScene(arguments.scene);
    printDiagnostics(parsed.diagnostics, *parsed.sources, true);
    const ShapePointer shape = shapeToTest(parsed, arguments.object);
    if (!shape) return inputHasErrors;

    TraceContext context(parsed.scene->parameterTable, RootFinder::lipschitz);
    std::cout << csvLine({"inside"});
    for (std::size_t row = 0; row < table->rowCount(); ++row) {
        const glm::dvec3 point{table->number(row, "x", 0), table->number(row, "y", 0),
                               table->number(row, "z", 0)};
        std::cout << csvLine({shape->contains(point, context) ? "1" : "0"});
    }
    return parsed.ok() ? done : inputHasErrors;
}

}  // namespace

void addInsideCommand(CommandLine& line) {
    Command command = line.add("inside", "Whether points lie in a solid, from and to CSV");
    auto arguments = std::make_shared<InsideArguments>();
    arguments->scene.addTo(command);
    command.option("--points", arguments->points, "CSV with x,y,z").required();
    command.option("--object", arguments->object, "Declared object to test (default: the whole scene)");
    command.run([=] { return testPoints(*arguments); });
}

}  // namespace isoscope::cli
