// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/table_row.h"
#include "app/cli/time_limit.h"
#include "core/evaluate/tape/loop_stop.h"

namespace isoscope::cli {

namespace {

struct InsideArguments {
    SceneArguments scene;
    std::string points;
    std::string object;
    WorkLimit work;
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
    ExitStatus status = parsed.ok() ? done : inputHasErrors;
    TimeLimit limit(arguments.work.seconds);
    for (std::size_t number = 0; number < table->rowCount(); ++number) {
        TableRow row(arguments.points, *table, number);
        const glm::dvec3 point = row.point("x", "y", "z");
        if (row.ok()) {
            limit.restart();
            const LoopStop loops(limit.token());
            const bool inside = shape->contains(point, context);
            if (!limit.over()) {
                std::cout << csvLine({inside ? "1" : "0"});
                continue;
            }
            arguments.work.error(row.place(), "there is no answer");
        }
        std::cout << csvLine({"error"});
        status = inputHasErrors;
    }
    return status;
}

}  // namespace

void addInsideCommand(CommandLine& line) {
    Command command = line.add("inside", "Whether points lie in a solid, from and to CSV");
    auto arguments = std::make_shared<InsideArguments>();
    arguments->scene.addTo(command);
    command.option("--points", arguments->points, "CSV with x,y,z").required();
    command.option("--object", arguments->object, "Declared object to test (default: the whole scene)");
    arguments->work.addTo(command, "Seconds to work on each row");
    command.run([=] { return testPoints(*arguments); });
}

}  // namespace isoscope::cli
